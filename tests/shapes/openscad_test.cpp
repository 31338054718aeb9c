#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <gtest/gtest.h>
#include <unistd.h>

#include "csg/shapes/extrude.hpp"
#include "csg/shapes/mesh_repair.hpp"
#include "csg/shapes/profile_boolean.hpp"

// The installed OpenSCAD 2021.01 is the reference: same volume to its six digits, same number of triangles.
namespace {

using namespace cardioid;
using namespace cardioid::csg;

const bool has_openscad = std::system("openscad --version >/dev/null 2>&1") == 0;

/// What OpenSCAD makes of a program.
TriangleMesh evaluated(const std::string& program) {
    const auto stem = std::filesystem::temp_directory_path() / ("cardioid_shapes_" + std::to_string(::getpid()));
    const std::string scad = stem.string() + ".scad", stl = stem.string() + ".stl";
    std::ofstream(scad) << program;
    const std::string command = "openscad -o '" + stl + "' '" + scad + "' >/dev/null 2>&1";
    TriangleMesh mesh;
    if (std::system(command.c_str()) == 0) {
        std::ifstream in(stl);
        std::string word;
        while (in >> word)
            if (Vec3d p; word == "vertex" && in >> p.x >> p.y >> p.z) mesh.vertices.push_back(p);
        for (std::uint32_t i = 0; i + 2 < mesh.vertices.size(); i += 3) mesh.triangles.push_back({i, i + 1, i + 2});
    }
    std::filesystem::remove(scad);
    std::filesystem::remove(stl);
    return mesh;
}

struct Case {
    const char* name;
    const char* program;
    std::function<TriangleMesh()> make;
    bool same_count = true;
    friend void PrintTo(const Case& c, std::ostream* out) { *out << c.program; }
};

constexpr double grid = 0x1p-16;

Profile clean(const Profile& p) { return profile_boolean(ProfileOp::unite, {&p, 1}, grid); }
Profile square(double a, double b) { return {{{{0, 0}, {a, 0}, {a, b}, {0, b}}}}; }
Profile circle(double r, double fn = 0) { return {{circle_points(r, facet_count(r, {fn, 12, 2}))}}; }
Profile moved(const Profile& p, double x, double y) { return transformed(p, Affine::translation({x, y, 0})); }
Profile combined(ProfileOp op, Profile a, Profile b) {
    const std::array<Profile, 2> parts{std::move(a), std::move(b)};
    return profile_boolean(op, parts, grid);
}
Profile lens() { return combined(ProfileOp::subtract, moved(circle(6, 20), 4, 0), moved(circle(3, 9), 5, 1)); }
LinearExtrusion how(double height, double twist, Vec2d scale = {1, 1}, int slices = 0, FacetSettings facets = {}) {
    return {height, false, twist, slices, scale, facets};
}

std::string name_of(const testing::TestParamInfo<Case>& which) { return which.param.name; }

class AgainstOpenScad : public testing::TestWithParam<Case> {};

TEST_P(AgainstOpenScad, HasItsVolumeAndItsTriangles) {
    if (!has_openscad) GTEST_SKIP() << "openscad is not installed";
    const TriangleMesh theirs = evaluated(GetParam().program), ours = GetParam().make();
    ASSERT_GT(theirs.triangles.size(), 0U);
    EXPECT_TRUE(ours.closed);
    EXPECT_NEAR(volume(ours), volume(theirs), 1e-5 * std::abs(volume(theirs)));
    if (GetParam().same_count) {
        EXPECT_EQ(ours.triangles.size(), theirs.triangles.size());
    }
}

const Case linear_cases[] = {
    {"Prism", "linear_extrude(7, center=true) square([3,4]);",
     [] { return linear_extrude(square(3, 4), {.height = 7, .centre = true}); }},
    {"Twist", "linear_extrude(height=10,twist=90) square(10);",
     [] { return linear_extrude(square(10, 10), how(10, 90)); }},
    {"TwistBack", "linear_extrude(height=10,twist=-200) translate([1,2]) square([10,3]);",
     [] { return linear_extrude(moved(square(10, 3), 1, 2), how(10, -200)); }},
    {"TwistByFs", "linear_extrude(height=30,twist=77,$fs=1.3,$fa=1) square([10,3]);",
     [] {
         return linear_extrude(square(10, 3), how(30, 77, {1, 1}, 0, {0, 1, 1.3}));
     }},
    {"TwistByFn", "linear_extrude(height=10,twist=123,$fn=17) square([5,3]);",
     [] {
         return linear_extrude(square(5, 3), how(10, 123, {1, 1}, 0, {17}));
     }},
    {"TwistOfARing",
     "linear_extrude(height=20,twist=300,slices=11) difference(){translate([4,0])circle(6,$fn=20);"
     "translate([5,1])circle(3,$fn=9);}",
     [] {
         return linear_extrude(lens(), how(20, 300, {1, 1}, 11));
     }},
    {"ScaleUp", "linear_extrude(height=10,scale=2.5) translate([1,0]) circle(3);",
     [] {
         return linear_extrude(moved(circle(3), 1, 0), how(10, 0, {2.5, 2.5}));
     }},
    {"ScaleUneven", "linear_extrude(height=10,scale=[2,0.5]) translate([1,0]) circle(3);",
     [] {
         return linear_extrude(moved(circle(3), 1, 0), how(10, 0, {2, 0.5}));
     }},
    {"ScaleUnevenByFn", "linear_extrude(height=10,scale=[2,0.5],$fn=13.7) square([3,4]);",
     [] {
         return linear_extrude(square(3, 4), how(10, 0, {2, 0.5}, 0, {13.7}));
     }},
    {"ConicalTwistUp", "linear_extrude(height=10,twist=100,scale=3,$fa=1) square([3,4]);",
     [] {
         return linear_extrude(square(3, 4), how(10, 100, {3, 3}, 0, {0, 1, 2}));
     }},
    {"ConicalTwistDown", "linear_extrude(height=50,twist=500,scale=0.3,$fa=1) square([3,4]);",
     [] {
         return linear_extrude(square(3, 4), how(50, 500, {0.3, 0.3}, 0, {0, 1, 2}));
     }},
    {"UnevenTwist", "linear_extrude(height=9,twist=40,scale=[3,0.4]) square([3,4]);",
     [] {
         return linear_extrude(square(3, 4), how(9, 40, {3, 0.4}));
     }},
    {"UnevenTwistFn", "linear_extrude(height=9,twist=40,scale=[3,0.4],$fn=20) square([3,4]);",
     [] {
         return linear_extrude(square(3, 4), how(9, 40, {3, 0.4}, 0, {20}));
     }},
    {"ToAPoint", "linear_extrude(height=9,scale=0) square([3,4]);",
     [] {
         return linear_extrude(square(3, 4), how(9, 0, {0, 0}));
     }},
    {"ToAnEdge", "linear_extrude(height=9,scale=[0,1]) translate([1,1]) square([3,4]);",
     [] {
         return linear_extrude(moved(square(3, 4), 1, 1), how(9, 0, {0, 1}));
     }},
    {"ToAnEdgeTwisted", "linear_extrude(height=9,twist=70,scale=[1.5,0]) translate([1,1]) square([3,4]);",
     [] {
         return linear_extrude(moved(square(3, 4), 1, 1), how(9, 70, {1.5, 0}));
     },
     false},
    {"ToAPointTwisted", "linear_extrude(height=9,twist=170,scale=0) square([3,4]);",
     [] {
         return linear_extrude(square(3, 4), how(9, 170, {0, 0}));
     }},
    {"Slices", "linear_extrude(height=9,slices=6,scale=[2,1]) square([3,4]);",
     [] {
         return linear_extrude(square(3, 4), how(9, 0, {2, 1}, 6));
     }},
    {"CollinearCorner", "linear_extrude(height=5,twist=60,slices=2) polygon([[0,0],[5,0],[10,0],[10,10],[0,10]]);",
     [] {
         return linear_extrude(clean({{{{0, 0}, {5, 0}, {10, 0}, {10, 10}, {0, 10}}}}), how(5, 60, {1, 1}, 2));
     }},
    {"StarOfEvenOdd", "linear_extrude(height=5,twist=20) polygon([for(i=[0:4])[9*cos(144*i),9*sin(144*i)]]);",
     [] {
         Profile star{{{}}};
         for (int i = 0; i < 5; ++i)
             star.contours[0].push_back(circle_points(9, 5)[static_cast<std::size_t>(2 * i % 5)]);
         return linear_extrude(clean(star), how(5, 20));
     }},
};
INSTANTIATE_TEST_SUITE_P(LinearExtrude, AgainstOpenScad, testing::ValuesIn(linear_cases), name_of);

// OpenSCAD leaves triangles without area on the axis, so only the volume counts where the profile meets it.
const Case rotate_cases[] = {
    {"Ring", "rotate_extrude($fn=7) translate([2,0]) square([3,4]);",
     [] { return rotate_extrude(moved(square(3, 4), 2, 0), 360, {7}); }},
    {"Torus", "rotate_extrude() translate([10,0]) circle(3);",
     [] { return rotate_extrude(moved(circle(3), 10, 0), 360, {}); }},
    {"Part", "rotate_extrude(angle=100) translate([2,0]) square([3,4]);",
     [] { return rotate_extrude(moved(square(3, 4), 2, 0), 100, {}); }},
    {"PartBack", "rotate_extrude(angle=-250,$fn=11) translate([2,0]) square([3,4]);",
     [] { return rotate_extrude(moved(square(3, 4), 2, 0), -250, {11}); }},
    {"LeftSide", "rotate_extrude(angle=100,$fn=11) translate([-6,0]) square([3,4]);",
     [] { return rotate_extrude(moved(square(3, 4), -6, 0), 100, {11}); }},
    {"LeftSideBack", "rotate_extrude(angle=-100,$fn=11) translate([-6,0]) square([3,4]);",
     [] { return rotate_extrude(moved(square(3, 4), -6, 0), -100, {11}); }},
    {"LeftSideFull", "rotate_extrude($fn=11) translate([-6,0]) square([3,4]);",
     [] { return rotate_extrude(moved(square(3, 4), -6, 0), 360, {11}); }},
    {"OnTheAxis", "rotate_extrude($fn=12) square([3,4]);", [] { return rotate_extrude(square(3, 4), 360, {12}); },
     false},
    {"OnTheAxisPart", "rotate_extrude($fn=12,angle=100) square([3,4]);",
     [] { return rotate_extrude(square(3, 4), 100, {12}); }, false},
    {"HalfBall", "rotate_extrude($fn=30) intersection(){circle(5,$fn=30);square(5);}",
     [] { return rotate_extrude(combined(ProfileOp::intersect, circle(5, 30), square(5, 5)), 360, {30}); }, false},
    {"RingWithHole",
     "rotate_extrude(angle=30) difference(){translate([9,0])circle(6,$fn=20);"
     "translate([9,1])circle(3,$fn=9);}",
     [] {
         return rotate_extrude(combined(ProfileOp::subtract, moved(circle(6, 20), 9, 0), moved(circle(3, 9), 9, 1)), 30,
                               {});
     }},
};
INSTANTIATE_TEST_SUITE_P(RotateExtrude, AgainstOpenScad, testing::ValuesIn(rotate_cases), name_of);

const Case solid_cases[] = {
    {"Sphere", "sphere(5);", [] { return faceted_sphere(5, facet_count(5, {})); }},
    {"OddSphere", "sphere(5,$fn=7);", [] { return faceted_sphere(5, facet_count(5, {7})); }},
    {"Cylinder", "cylinder(h=4,r=3);", [] { return faceted_cone(4, 3, 3, facet_count(3, {})); }},
    {"Frustum", "cylinder(h=4,r1=3,r2=1,$fn=9);", [] { return faceted_cone(4, 3, 1, 9); }},
    {"Cone", "cylinder(h=4,r1=3,r2=0,$fn=9);", [] { return faceted_cone(4, 3, 0, 9); }},
    {"ConeUpsideDown", "cylinder(h=4,r1=0,r2=3,$fn=5);", [] { return faceted_cone(4, 0, 3, 5); }},
};
INSTANTIATE_TEST_SUITE_P(Facets, AgainstOpenScad, testing::ValuesIn(solid_cases), name_of);

/// A prism over a polygon in the plane across `axis`, its lid bent so that it is not planar.
TriangleMesh bent_prism(const std::vector<Vec2d>& base, int axis, double height, std::string& program) {
    std::vector<Vec3d> points;
    std::vector<std::vector<std::uint32_t>> faces(2);
    const auto n = static_cast<std::uint32_t>(base.size());
    for (std::uint32_t i = 0; i < 2 * n; ++i) {
        Vec3d p;
        p[axis] = i < n ? 0 : height + (i == n + 1 ? 0.0625 : 0);
        p[(axis + 1) % 3] = base[i % n].x, p[(axis + 2) % 3] = base[i % n].y;
        points.push_back(p);
    }
    for (std::uint32_t i = 0; i < n; ++i) {
        faces[0].push_back(height > 0 ? i : n - 1 - i);
        faces[1].push_back(height > 0 ? 2 * n - 1 - i : n + i);
        std::vector<std::uint32_t> side{i, i + n, (i + 1) % n + n, (i + 1) % n};
        if (height < 0) std::ranges::reverse(side);
        faces.push_back(side);
    }
    program = "polyhedron(points=[";
    for (const Vec3d p : points)
        program += "[" + std::to_string(p.x) + "," + std::to_string(p.y) + "," + std::to_string(p.z) + "],";
    program += "],faces=[";
    for (const auto& face : faces) {
        program += "[";
        for (const std::uint32_t i : face) program += std::to_string(i) + ",";
        program += "],";
    }
    program += "]);";
    MeshFaults faults;
    TriangleMesh out = triangulate_polyhedron(points, faces, faults);
    EXPECT_EQ(faults.non_planar_faces, 1U);
    EXPECT_TRUE(repair(out).closed());
    return out;
}

TEST(Polyhedron, CutsFacesThatAreNotPlanarAsOpenScad) {
    if (!has_openscad) GTEST_SKIP() << "openscad is not installed";
    const std::vector<std::vector<Vec2d>> bases{{{0, 0}, {1, 0}, {1, 1}, {0, 1}},
                                                {{0, 0}, {1, -1}, {2, -1}, {3, 0}},
                                                {{0, 0}, {3, 0}, {2, 1}, {1, 1}},
                                                {{0, 0}, {1, 1}, {1, 2}, {0, 3}},
                                                {{0, 0}, {2, 1}, {1, 3}, {-1, 2}},
                                                {{0, 0}, {2, -1}, {3, 1}, {1, 2}},
                                                {{0, 0}, {1, -1}, {2, 0}, {1, 1}},
                                                {{0, 0}, {4, 0}, {5, 3}, {0, 2}},
                                                {{0, 0}, {4, 0}, {1, 1}, {0, 3}},
                                                {{0, 0}, {5, 0}, {7, 3}, {3, 6}, {-1, 4}},
                                                {{0, 0}, {9, 0}, {9, 2}, {3, 3}, {2, 7}, {0, 7}}};
    for (const auto& base : bases)
        for (const int axis : {0, 1, 2})
            for (const double height : {2.0, -2.0}) {
                std::string program;
                const TriangleMesh ours = bent_prism(base, axis, height, program);
                const double theirs = volume(evaluated(program));
                EXPECT_NEAR(volume(ours), theirs, 1e-5 * theirs) << program;
            }
}

}  // namespace
