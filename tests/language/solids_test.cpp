#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/language/read.hpp"

using namespace cardioid;
using cardioid::test::contains;
using cardioid::test::error_of;
using cardioid::test::read;
using cardioid::test::tree_of;
using cardioid::test::warnings_of;

namespace {

Leaf leaf_of(const std::string& text, ReadOptions options = {}) { return read(text, options).solids.leaves.at(0); }

ReadOptions facets() {
    ReadOptions out;
    out.openscad_facets = true;
    return out;
}

}  // namespace

TEST(Solids, CubeIsABoxOfItsSize) {
    const Leaf cube = leaf_of("cube(size = [1, 2, 3], center = true);");
    EXPECT_EQ(cube.to_world.point({0, 0, 0}), Vec3d(-0.5, -1, -1.5));
    EXPECT_EQ(cube.to_world.point({1, 1, 1}), Vec3d(0.5, 1, 1.5));
    EXPECT_EQ(leaf_of("cube(3);").to_world.point({1, 1, 1}), Vec3d(3, 3, 3));
    EXPECT_EQ(leaf_of("cube();").to_world, Affine{});
}

TEST(Solids, SphereKnowsRadiusAndDiameter) {
    EXPECT_EQ(leaf_of("sphere();").to_world, Affine{});
    EXPECT_EQ(leaf_of("sphere(5);").to_world.row[0].x, 5);
    EXPECT_EQ(leaf_of("sphere(r = 5, d = 4);").to_world.row[0].x, 2);
    EXPECT_EQ(leaf_of("sphere(r = 3, 1);").to_world.row[0].x, 1) << "unnamed arguments fill the list in order";
}

TEST(Solids, CylinderKnowsEverySpellingOfItsRadii) {
    const auto radii = [](const std::string& arguments) {
        const Leaf leaf = leaf_of("cylinder(" + arguments + ");");
        return std::pair(leaf.a, leaf.b);
    };
    EXPECT_EQ(radii(""), std::pair(1.0, 1.0));
    EXPECT_EQ(radii("h = 10, d = 4"), std::pair(2.0, 2.0));
    EXPECT_EQ(radii("10, 3, 2"), std::pair(3.0, 2.0));
    EXPECT_EQ(radii("r1 = 0, r2 = 2"), std::pair(0.0, 2.0));
    EXPECT_EQ(radii("d1 = 6, r = 1"), std::pair(3.0, 1.0));
    const Leaf centred = leaf_of("cylinder(h = 10, center = true);");
    EXPECT_EQ(centred.to_world.point({0, 0, 0}), Vec3d(0, 0, -5));
    EXPECT_EQ(centred.to_world.point({0, 0, 1}), Vec3d(0, 0, 5));
}

TEST(Solids, SizesThatEncloseNothingAreRemovedWithAWarning) {
    for (const char* text :
         {"cube(0);", "cube([1, -1, 1]);", "cube(inf);", "cube([1, nan, 1]);", "sphere(0);", "sphere(r = -2);",
          "sphere(inf);", "cylinder(h = 0);", "cylinder(r1 = 0, r2 = 0);", "cylinder(r1 = -1, r2 = 2);",
          "cylinder(h = inf);", "cylinder(r = nan);", "torus(R = 3, r = 0);", "ellipsoid([1, 0, 1]);",
          "half_space([0, 0, 0], 1);", "half_space([0, 0, 1], inf);", "polyhedron(points = undef, faces = undef);",
          "polyhedron(points = [[0, 0, 0]], faces = [[0, 1, 2]]);"}) {
        const Scene scene = read(text);
        EXPECT_EQ(tree_of(scene), "") << text;
        EXPECT_TRUE(contains(warnings_of(scene), "removed")) << text;
    }
}

TEST(Solids, BeyondWhatCanBeTracedAreRemovedWithAWarning) {
    for (const char* text : {"sphere(1e30);", "translate([1e20, 0, 0]) sphere(1);", "cube([1, 1, 1e16]);"}) {
        const Scene scene = read(text);
        EXPECT_EQ(tree_of(scene), "") << text;
        EXPECT_TRUE(contains(warnings_of(scene), "larger than 1e15 or farther out: removed")) << text;
    }
    EXPECT_EQ(tree_of(read("translate([1e14, 0, 0]) sphere(1e12);")), "ball");
}

TEST(Solids, FewFacetsStayAndManyBecomeCurves) {
    EXPECT_EQ(tree_of(read("sphere(r = 1, $fn = 0);")), "ball");
    EXPECT_EQ(tree_of(read("sphere(r = 1, $fn = 6);")), "mesh");
    EXPECT_EQ(tree_of(read("sphere(r = 1, $fn = 23);")), "mesh");
    EXPECT_EQ(tree_of(read("sphere(r = 1, $fn = 24);")), "ball");
    EXPECT_EQ(tree_of(read("cylinder(h = 1, $fn = 6);")), "prism");
    EXPECT_EQ(tree_of(read("cylinder(h = 1, $fn = 1);")), "prism") << "a triangle, as in OpenSCAD";
    EXPECT_EQ(tree_of(read("cylinder(h = 1, r1 = 1, r2 = 0, $fn = 6);")), "mesh");
    EXPECT_EQ(tree_of(read("cylinder(h = 1, $fn = inf);")), "prism") << "three facets, as in OpenSCAD";
    ReadOptions from_50;
    from_50.smooth_from = 50;
    EXPECT_EQ(tree_of(read("sphere(r = 1, $fn = 49);", from_50)), "mesh");
}

TEST(Solids, FacetsModeHasNoCurves) {
    EXPECT_EQ(tree_of(read("sphere(5); cylinder(h = 1, r = 5); cylinder(h = 1, $fn = 100);", facets())),
              "mesh prism mesh");
    EXPECT_EQ(read("cylinder(h = 1, r = 5);", facets()).solids.profiles[0]->contours[0].size(), 16U)
        << "2 pi 5 / $fs = 15.7 facets";
}

TEST(Solids, EqualFacetsAreKeptOnce) {
    const Scene scene =
        read("sphere(1, $fn = 4); sphere(2, $fn = 4); cylinder(r = 1, $fn = 6); cylinder(r = 2, $fn = 6);");
    EXPECT_EQ(scene.solids.meshes.size(), 1U);
    EXPECT_EQ(scene.solids.profiles.size(), 1U);
}

TEST(Solids, AFacetedFrustumIsAPrismWithASmallerTop) {
    const Leaf leaf = leaf_of("cylinder(h = 3, r1 = 4, r2 = 2, $fn = 6);");
    EXPECT_EQ(leaf.kind, LeafKind::prism);
    EXPECT_EQ(leaf.a, 0.5);
    EXPECT_EQ(leaf.to_world.point({1, 0, 1}), Vec3d(4, 0, 3));
}

TEST(Solids, AFacetedConeStandsOnItsPointWhereItsFootIsZero) {
    const Scene scene = read("cylinder(h = 3, r1 = 0, r2 = 2, $fn = 4);");
    const Leaf& leaf = scene.solids.leaves[0];
    double widest = 0;
    for (const Vec3d v : scene.solids.meshes[leaf.data]->vertices) {
        const Vec3d p = leaf.to_world.point(v);
        EXPECT_TRUE(p.z > 1.5 || p == Vec3d(0, 0, 0));
        if (p.z > 1.5) widest = std::max(widest, p.x);
    }
    EXPECT_EQ(widest, 2);
}

TEST(Solids, TorusEllipsoidAndHalfSpace) {
    const Leaf torus = leaf_of("torus(R = 10, r = 2);");
    EXPECT_EQ(torus.kind, LeafKind::torus);
    EXPECT_EQ(std::pair(torus.a, torus.b), std::pair(10.0, 2.0));
    EXPECT_TRUE(contains(error_of("torus(2, 2);"), "wanted r < R"));
    EXPECT_TRUE(contains(error_of("torus(2);"), "torus(R = 10, r = 2)"));
    EXPECT_EQ(leaf_of("ellipsoid([1, 2, 3]);").to_world, Affine::scaling({1, 2, 3}));
    EXPECT_EQ(leaf_of("half_space([0, 0, 1], 0);").to_world, Affine{});
    for (const Vec3d n : {Vec3d{0, 0, -2}, {1, 0, 0}, {0, -3, 0}, {1, 2, -2}}) {
        const Leaf half = leaf_of("half_space([" + std::to_string(n.x) + "," + std::to_string(n.y) + "," +
                                  std::to_string(n.z) + "], 6);");
        EXPECT_GT(half.to_world.determinant(), 0.999);
        EXPECT_LT(dot(n, half.to_world.point({3, -4, -0.001})), 6) << "below the plane is inside";
        EXPECT_GT(dot(n, half.to_world.point({3, -4, 0.001})), 6);
    }
}

TEST(Solids, PolyhedronFacesRunClockwise) {
    const Scene scene =
        read("polyhedron(points = [[0,0,0],[1,0,0],[0,1,0],[0,0,1]], faces = [[0,1,2],[0,3,1],[0,2,3],[1,3,2]]);");
    ASSERT_EQ(tree_of(scene), "mesh");
    EXPECT_TRUE(scene.solids.meshes[0]->closed);
    EXPECT_EQ(warnings_of(scene), "");
    const Scene old =
        read("polyhedron(points = [[0,0,0],[1,0,0],[0,1,0],[0,0,1]], triangles = [[0:2],[0,3,1],[0,2,3],[1,3,2]]);");
    EXPECT_TRUE(old.solids.meshes[0]->closed) << "a range is a face too";
}

TEST(Solids, BadCornersOfAPolyhedronAreLeftOutWithAWarning) {
    for (const char* face : {"[0, 1, 7]", "[0, 1, -1]", "[0, 1, nan]", "[0, 1, \"x\"]", "3", "[0:1e9]", "[0, 1, 4]"}) {
        const Scene scene = read(
            std::string("polyhedron(points = [[0,0,0],[1,0,0],[0,1,0],[0,0,1]], faces = [[0,3,1],[0,2,3],[1,3,2],") +
            face + "]);");
        EXPECT_TRUE(contains(warnings_of(scene), "1 faces of the polyhedron have bad corners")) << face;
        EXPECT_TRUE(contains(warnings_of(scene), "the mesh is not closed: 3 open edges")) << face;
    }
}

TEST(Solids, APolyhedronWithAPointThatIsNowhereIsRemovedWithAWarning) {
    for (const char* point : {"[inf, 0, 0]", "[nan, 0, 0]", "[undef]", "\"x\""}) {
        const Scene scene = read(std::string("polyhedron(points = [") + point +
                                 ",[1,0,0],[0,1,0],[0,0,1]], faces = [[0,1,2],[0,3,1],[0,2,3],[1,3,2]]);");
        EXPECT_EQ(scene.solids.leaves.size(), 0U) << point;
        EXPECT_TRUE(contains(warnings_of(scene), "not three finite numbers: removed")) << point;
    }
}

TEST(Solids, ImportReadsMeshesBesideTheSceneAndSharesThem) {
    const auto folder =
        std::filesystem::temp_directory_path() / ("cardioid_language_import_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "t.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    ReadOptions options;
    options.base_dir = folder.string();
    const Scene scene =
        read("import(file = \"t.obj\", origin = [0, 0], timestamp = 0); include_mesh(\"t.obj\");", options);
    EXPECT_EQ(tree_of(scene), "mesh mesh");
    EXPECT_EQ(scene.solids.meshes.size(), 1U);
    EXPECT_EQ(warnings_of(scene), "");
    std::filesystem::remove_all(folder);
}

TEST(Solids, AnImportThatIsMissingIsALoudWarning) {
    for (const char* call : {"import(file = \"nowhere.stl\");", "import(file = \"nowhere.dxf\");",
                             "linear_extrude(file = \"nowhere.dxf\", height = 1);", "surface(\"nowhere.dat\");"}) {
        const Scene scene = read("cube(1);\nunion() {\n\t" + std::string(call) + "\n}");
        EXPECT_EQ(tree_of(scene), "box") << call;
        EXPECT_TRUE(contains(warnings_of(scene), "t.csg:3:2: ./nowhere.")) << call;
        EXPECT_TRUE(contains(warnings_of(scene), "cannot read it: No such file or directory")) << call;
        EXPECT_TRUE(contains(warnings_of(scene), "THE PICTURE IS WITHOUT IT")) << call;
    }
    // In a difference it is the minuend that is empty, as in OpenSCAD.
    EXPECT_EQ(tree_of(read("cube(1); difference() { import(file = \"nowhere.stl\"); cube(1); }")), "box");
}

TEST(Solids, AMissingIncludedMeshIsAnErrorWithItsPlace) {
    try {
        read("group() {\n\tinclude_mesh(file = \"nowhere.stl\");\n}");
        FAIL() << "a hole must not be silent";
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), ErrorCode::io);
        EXPECT_TRUE(std::string(e.what()).starts_with("t.csg:2:2: "));
        EXPECT_TRUE(contains(e.what(), "nowhere.stl"));
    }
}

TEST(Solids, SixDigitsAreToldFromLongerOnes) {
    EXPECT_TRUE(read("cube([0.707107, 1, 1]); import_free();", {.unknown_is_warning = true}).six_digits);
    EXPECT_FALSE(read("cube([0.70710678, 1, 1]);").six_digits);
    EXPECT_TRUE(read("camera([0.70710678, 1, 1]); cube();").six_digits) << "the camera is no part of the model";
    EXPECT_FALSE(read("precision(digits = 17); cube();").six_digits);
}
