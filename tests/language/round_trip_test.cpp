#include <filesystem>
#include <gtest/gtest.h>

#include "formats/openscad/openscad_format.hpp"
#include "formats/openscad/syntax/parser.hpp"
#include "formats/openscad/syntax/printer.hpp"
#include "tests/language/read.hpp"
#include "tests/text_file.hpp"

using namespace cardioid;
namespace fs = std::filesystem;

namespace {

/// Everything a scene says but the places it was said at.
void expect_same(const Scene& a, const Scene& b) {
    EXPECT_EQ(test::tree_of(a), test::tree_of(b));
    ASSERT_EQ(a.solids.leaves.size(), b.solids.leaves.size());
    for (std::size_t i = 0; i < a.solids.leaves.size(); ++i) {
        const Leaf &x = a.solids.leaves[i], &y = b.solids.leaves[i];
        EXPECT_TRUE(x.to_world == y.to_world && x.a == y.a && x.b == y.b && x.material == y.material) << i;
        if (x.kind == LeafKind::mesh) {
            EXPECT_EQ(a.solids.meshes[x.data]->vertices, b.solids.meshes[y.data]->vertices) << i;
            EXPECT_EQ(a.solids.meshes[x.data]->triangles, b.solids.meshes[y.data]->triangles) << i;
        } else if (x.kind == LeafKind::prism || x.kind == LeafKind::revolution) {
            EXPECT_EQ(a.solids.profiles[x.data]->contours, b.solids.profiles[y.data]->contours) << i;
        }
    }
    ASSERT_EQ(a.materials.size(), b.materials.size());
    for (std::size_t i = 0; i < a.materials.size(); ++i) {
        EXPECT_EQ(a.materials[i].name, b.materials[i].name);
        EXPECT_EQ(a.materials[i].kind, b.materials[i].kind);
        EXPECT_EQ(a.materials[i].params.all().size(), b.materials[i].params.all().size());
    }
    EXPECT_EQ(a.six_digits, b.six_digits);
}

void expect_round_trip(const Scene& scene) {
    const std::string text = formats::csg_format.write(scene, {});
    const Scene again = test::read(text);
    expect_same(scene, again);
    EXPECT_EQ(formats::csg_format.write(again, {}), text);
}

/// Every .csg below a folder: parse(print(parse(f))) is parse(f).
void expect_syntax_round_trips(const fs::path& folder) {
    if (!fs::exists(folder)) GTEST_SKIP() << folder << " is not there (packages openscad, openscad-testing-data)";
    std::size_t files = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.path().extension() != ".csg") continue;
        const auto ast = formats::openscad::parse(test::file_text(entry.path()), entry.path().string());
        const auto again = formats::openscad::parse(formats::openscad::print(ast), "printed");
        EXPECT_TRUE(formats::openscad::equal(ast, again)) << entry.path();
        ++files;
    }
    EXPECT_GT(files, 0U);
}

}  // namespace

TEST(RoundTrip, EverySyntaxTreeOfOpenscadsOwnTestsComesBack) {
    expect_syntax_round_trips("/usr/share/openscad/regression");
}

TEST(RoundTrip, EveryEvaluatedTestComesBackAsTheSameSceneOrIsRefusedByName) {
    const fs::path folder = "/usr/share/openscad/regression";
    if (!fs::exists(folder)) GTEST_SKIP() << folder << " is not there (package openscad-testing-data)";
    std::size_t read = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.path().extension() != ".csg") continue;
        SCOPED_TRACE(entry.path().string());
        ReadOptions options;
        options.registry = &test::small_registry();
        Scene scene;
        const std::string text = test::file_text(entry.path());
        // Exact booleans over curves as fine as a picture wants them would take a minute.
        options.openscad_facets =
            text.find("projection(") != std::string::npos || text.find("minkowski(") != std::string::npos;
        try {
            scene = formats::csg_format.read(text, entry.path().string(), options);
        } catch (const Error& e) {
            EXPECT_TRUE(std::string(e.what()).starts_with(entry.path().string() + ":")) << e.what();
            continue;
        }
        if (scene.solids.leaves.size() < 2000) expect_round_trip(scene);
        ++read;
    }
    EXPECT_GT(read, 50U);
}

TEST(RoundTrip, EveryKindOfLeafComesBackToTheLastBit) {
    expect_round_trip(test::read(
        "rotate([10, 20, 30]) translate([0.1, 0.2, 0.3]) { cube(1.1); sphere(2.3); cylinder(h = 3, r1 = 1, r2 = 0.3);\n"
        "torus(3, 0.7); half_space([1, 2, 3], 4); ellipsoid([1, 2, 3]); sphere(1, $fn = 7);\n"
        "cylinder(r1 = 1, r2 = 3, $fn = 5); linear_extrude(3, scale = 0.3) polygon([[0.1, 0], [1, 0.7], [0, 1]]);\n"
        "rotate_extrude() translate([1, 1]) square([0.1, 0.2]); rotate_extrude(angle = 77) translate([2, 0]) "
        "circle(0.3);\n"
        "linear_extrude(1, twist = 33) square(2); linear_extrude(2) difference() { circle(3); square(1); } }"));
}

TEST(RoundTrip, TreesMaterialsLightsAndCamerasComeBack) {
    const Scene scene = test::read(
        "film([64, 48], samples = 4, exposure = 1); camera([1, 2, 3], name = \"a \\\"b\\\"\", fov_axis = \"x\");\n"
        "camera([1, 2, 3], projection = \"orthographic\", width = 3.5); photons(count = 7);\n"
        "define_material(\"g\", kind = \"dielectric\", ior = 1.3); precision(digits = 17);\n"
        "translate([0.3, 0, 0]) area_light([1, 2], radiance = [1, 2, 3]); point_light();\n"
        "difference() { union() { cube(); material(\"g\") sphere(); } color(\"red\", 0.5) cube();\n"
        "intersection() { cube(); group() { sphere(); cylinder(); } } }");
    expect_round_trip(scene);
    const Scene again = test::read(formats::csg_format.write(scene, {}));
    EXPECT_EQ(again.film.width, 64);
    EXPECT_EQ(again.cameras.at(0).name, "a \"b\"");
    EXPECT_EQ(again.cameras.at(1).width, 3.5);
    EXPECT_EQ(again.lights.at(0).to_world, scene.lights[0].to_world);
    EXPECT_EQ(again.photons.number("count", 0), 7);
}

TEST(RoundTrip, FacetedScenesComeBack) {
    ReadOptions options;
    options.openscad_facets = true;
    expect_round_trip(
        test::read("difference() { sphere(5); cylinder(h = 9, r = 2, center = true); cylinder(r1 = 3, r2 = 0); }"
                   "linear_extrude(3) circle(5);",
                   options));
}

TEST(RoundTrip, MaterialsOfOtherFormatsGetNamesOfTheirOwn) {
    Scene scene = test::read("cube(); sphere();");
    scene.materials.push_back({"", "diffuse", {}});
    scene.materials.push_back({"", "diffuse", {}});
    scene.materials.push_back({"default", "dielectric", {}});
    scene.solids.leaves[0].material = 2;
    scene.solids.leaves[1].material = 3;
    const Scene again = test::read(formats::csg_format.write(scene, {}));
    EXPECT_EQ(again.materials.size(), 4U);
    EXPECT_EQ(again.solids.leaves[0].material, 2U);
    EXPECT_EQ(again.materials[again.solids.leaves[1].material].kind, "dielectric");
}
