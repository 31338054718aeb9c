#include <array>
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <random>

#include "csg/compile.hpp"
#include "csg/measure.hpp"
#include "formats/mesh/mesh_file.hpp"
#include "rt_core/math/box.hpp"
#include "tests/models/corpus.hpp"
#include "tests/models/mesh_distance.hpp"

// Points of space against the mesh that OpenSCAD exports.
namespace {

using namespace cardioid;
using namespace cardioid::test;

constexpr int point_count = 2000;
constexpr double near_share = 1e-5;  ///< of the diagonal: the mesh has 6 digits a coordinate

const std::array<Vec3d, 2> directions{normalize(Vec3d{0.3217, 0.8123, 0.4871}),
                                      normalize(Vec3d{-0.7411, 0.1937, 0.6427})};

/// Whether p is inside, by a line through it along d that begins and ends outside.
bool inside_by_spans(const Region& region, Vec3d p, Vec3d d, double reach) {
    for (const csg::Span& span : csg::inside_spans(region, p - d * reach, d, 2 * reach))
        if (span.begin <= reach && reach < span.end) return true;
    return false;
}

struct Disagreements {
    int near_surface = 0, far = 0, unsure = 0;
};

Disagreements compare(const Region& region, const TriangleMesh& mesh) {
    Box3d box;
    for (const Vec3d v : mesh.vertices) box.include(v);
    const double diagonal = length(box.size());
    std::mt19937_64 rng(1);
    std::uniform_real_distribution<double> share(-0.02, 1.02);
    Disagreements found;
    for (int i = 0; i < point_count; ++i) {
        const Vec3d size = box.size(), u{share(rng), share(rng), share(rng)};
        const Vec3d p = box.lo + Vec3d{u.x * size.x, u.y * size.y, u.z * size.z};
        const bool theirs = inside_by_parity(mesh, p, directions[0]);
        if (inside_by_parity(mesh, p, directions[1]) != theirs) {
            ++found.unsure;  // one of the rays met an edge
            continue;
        }
        const bool agree = inside_by_spans(region, p, directions[0], 3 * diagonal) == theirs &&
                           inside_by_spans(region, p, directions[1], 3 * diagonal) == theirs &&
                           region.sides(p, directions[0]).front == theirs;
        if (!agree) ++(distance_to(mesh, p) <= near_share * diagonal ? found.near_surface : found.far);
    }
    return found;
}

void check_points(const std::string& name) {
    const std::filesystem::path program = openscad_share / name;
    const auto csg = evaluated(program, ".csg"), stl = evaluated(program, ".stl");
    ASSERT_TRUE(csg && stl) << name;
    const Scene scene = read_evaluated(*csg, program);
    const auto region = csg::compile_whole(scene.solids, scene.six_digits);
    const Disagreements found = compare(*region, formats::read_mesh(stl->string()));
    fmt::print("{:<50} {} points: {} differ near a surface, {} far from it, {} unsure\n", name, point_count,
               found.near_surface, found.far, found.unsure);
    EXPECT_EQ(found.far, 0) << name;
    EXPECT_LE(found.near_surface, point_count / 500) << name;
    EXPECT_LE(found.unsure, point_count / 500) << name;
}

}  // namespace

TEST(Membership, OfPointsInAnExampleIsThatOfOpenScadsMesh) {
    if (!has_openscad()) GTEST_SKIP() << "openscad is not installed";
    if (programs_below("examples").empty()) GTEST_SKIP() << "openscad's examples are not installed";
    for (const char* name :
         {"Old/example001", "Old/example003", "Old/example012", "Old/example016", "Basics/CSG", "Basics/projection",
          "Basics/text_on_cube", "Old/example006", "Old/example009", "Old/example010"})
        check_points(std::string("examples/") + name + ".scad");
}

TEST(Membership, OfPointsInATestModelIsThatOfOpenScadsMesh) {
    if (!long_tests()) GTEST_SKIP() << "openscad needs a while for these: set CARDIOID_LONG_TESTS=1";
    if (!has_openscad()) GTEST_SKIP() << "openscad is not installed";
    if (programs_below("testdata").empty()) GTEST_SKIP() << "apt install openscad-testing-data";
    for (const char* name : {"cylinder-tests", "for-nested-tests", "linear_extrude-parameter-tests",
                             "linear_extrude-tests", "rotate_extrude-tests", "sphere-tests", "testcolornames"})
        check_points(std::string("testdata/scad/3D/features/") + name + ".scad");
    for (const char* name : {"example019", "example022", "example024"})
        check_points(std::string("examples/Old/") + name + ".scad");
}

TEST(Membership, SeesAModelThatIsTwoPercentTooLarge) {
    if (!has_openscad()) GTEST_SKIP() << "openscad is not installed";
    const std::filesystem::path program = openscad_share / "examples/Old/example001.scad";
    if (!std::filesystem::exists(program)) GTEST_SKIP() << "openscad's examples are not installed";
    Scene scene = read_evaluated(*evaluated(program, ".csg"), program);
    for (Leaf& leaf : scene.solids.leaves) leaf.to_world = Affine::scaling({1.02, 1.02, 1.02}) * leaf.to_world;
    const auto region = csg::compile_whole(scene.solids, scene.six_digits);
    EXPECT_GT(compare(*region, formats::read_mesh(evaluated(program, ".stl")->string())).far, 0);
}
