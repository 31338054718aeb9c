#include <gtest/gtest.h>

#include "csg/shapes/facets.hpp"
#include "rt_core/trace/geometry.hpp"
#include "tests/csg/models.hpp"

namespace cardioid::csg {
namespace {

using test::ball_leaf;
using test::box_leaf;

Leaf of_material(Leaf leaf, std::uint32_t material) {
    leaf.material = material;
    return leaf;
}

TEST(Compile, MembersOfAnOpaqueUnionAreSolidsOfTheirOwn) {
    Scene scene;
    SolidTree& t = scene.solids;
    const auto inner =
        t.add_node(SolidOp::unite, {t.add_leaf(ball_leaf({0, 0, 0}, 1)), t.add_leaf(ball_leaf({3, 0, 0}, 1))});
    t.roots = {inner, t.add_leaf(box_leaf({6, 0, 0}, {1, 1, 1}))};
    EXPECT_EQ(compile(scene, {}).regions.size(), 3U);
}

TEST(Compile, MembersOfOneGlassAreOneSolidWithoutInnerFaces) {
    Scene scene;
    SolidTree& t = scene.solids;
    t.roots = {t.add_leaf(of_material(ball_leaf({0, 0, 0}, 1), 1)),
               t.add_leaf(of_material(ball_leaf({1, 0, 0}, 1), 1))};
    const Geometry geometry = compile(scene, {false, true});
    ASSERT_EQ(geometry.regions.size(), 1U);
    Hit hit;
    ASSERT_TRUE(geometry.regions[0]->first_boundary({{-0.5, 0, 0}, {1, 0, 0}, 1e9, {}, {}}, 0, hit));
    EXPECT_NEAR(hit.t, 2.5, 1e-12);
}

TEST(Compile, AMeshOutsideOfBooleansIsASurface) {
    Scene scene;
    SolidTree& t = scene.solids;
    Leaf mesh;
    mesh.kind = LeafKind::mesh;
    mesh.data = t.add_mesh(faceted_sphere(1, 12));
    t.roots = {t.add_leaf(mesh),
               t.add_node(SolidOp::subtract, {t.add_leaf(mesh), t.add_leaf(ball_leaf({1, 0, 0}, 0.5))})};
    const Geometry geometry = compile(scene, {});
    EXPECT_EQ(geometry.surfaces.size(), 1U);
    EXPECT_EQ(geometry.regions.size(), 1U);
}

TEST(Compile, EmptySolidsVanish) {
    Scene scene;
    SolidTree& t = scene.solids;
    const auto empty = t.add_node(SolidOp::unite, {});
    const auto ball = [&] { return t.add_leaf(ball_leaf({0, 0, 0}, 1)); };
    t.roots = {t.add_node(SolidOp::subtract, {empty, ball()}), t.add_node(SolidOp::intersect, {ball(), empty}),
               t.add_node(SolidOp::intersect, {}), t.add_node(SolidOp::subtract, {}),
               t.add_node(SolidOp::intersect, {ball(), t.add_leaf(ball_leaf({5, 0, 0}, 1))})};
    EXPECT_EQ(compile(scene, {}).regions.size(), 0U);
    EXPECT_EQ(compile_whole(t, true), nullptr);
}

TEST(Compile, CuttersThatMissAreDropped) {
    SolidTree t;
    std::vector<std::uint32_t> nodes{t.add_leaf(box_leaf({0, 0, 0}, {1, 1, 1}))};
    for (int i = 0; i < 50; ++i) nodes.push_back(t.add_leaf(ball_leaf({5.0 + i, 0, 0}, 1)));
    t.roots = {t.add_node(SolidOp::subtract, nodes)};
    EXPECT_EQ(test::whole(t, true)->leaf_count(), 1U);
}

TEST(Compile, AChainOfDifferencesIsOneFlatGate) {
    SolidTree t;
    std::uint32_t chain = t.add_leaf(box_leaf({0, 0, 0}, {100, 100, 100}));
    for (int i = 0; i < 100000; ++i)
        chain = t.add_node(SolidOp::subtract, {chain, t.add_leaf(ball_leaf({i % 100 * 1.0, i / 1000 * 1.0, 50}, 0.3))});
    t.roots = {chain};
    const auto region = test::whole(t, true);
    EXPECT_EQ(region->gates().gates.size(), 1U);
}

TEST(Compile, ADeepChainOfCoincidentFacesIsSwept) {
    SolidTree t;  // A - (A - (A - ... B)): every face of every level at one place
    const int levels = 2000;
    std::uint32_t chain = t.add_leaf(ball_leaf({0, 0, 0}, 1));
    for (int i = 0; i < levels; ++i)
        chain = t.add_node(SolidOp::subtract, {t.add_leaf(box_leaf({-2, -2, -2}, {4, 4, 4})), chain});
    t.roots = {chain};
    std::vector<Boundary> all;
    const auto region = test::whole(t, true);
    region->boundaries({{-5, 0.1, 0.2}, {1, 0, 0}, 1e9, {}, {}}, all);
    EXPECT_EQ(all.size(), 2U);  // an even number of levels leaves the ball
    region->boundaries({{-5, 1.5, 0.2}, {1, 0, 0}, 1e9, {}, {}}, all);
    EXPECT_EQ(all.size(), 0U);
}

TEST(Compile, ALeafCostsNoMoreThanTwoHundredBytes) {
    test::Random random(1);
    SolidTree t;
    std::vector<std::uint32_t> nodes{t.add_leaf(box_leaf({0, 0, 0}, {100, 100, 100}))};
    for (int i = 0; i < 5000; ++i) nodes.push_back(t.add_leaf(ball_leaf(random.point(0, 100), random(1, 4))));
    t.roots = {t.add_node(SolidOp::subtract, nodes)};
    const auto region = test::whole(t, true);
    EXPECT_LE(region->memory_bytes(), 200 * region->leaf_count());
    Scene scene;
    for (int i = 0; i < 10; ++i) scene.solids.roots.push_back(scene.solids.add_leaf(ball_leaf(random.point(0, 9), 1)));
    for (const auto& r : compile(scene, {}).regions) EXPECT_LE(r->memory_bytes(), 200U);
}

TEST(Compile, AnUnboundedSolidIsTracedToo) {
    SolidTree t;
    Leaf ground;
    ground.kind = LeafKind::half_space;
    t.roots = {t.add_node(SolidOp::subtract, {t.add_leaf(ground), t.add_leaf(ball_leaf({0, 0, 0}, 1))})};
    const auto region = test::whole(t, true);
    EXPECT_FALSE(region->bounds().bounded());
    Hit hit;
    ASSERT_TRUE(region->first_boundary({{0.1, 0, 10}, {0, 0, -1}, 1e9, {}, {}}, 0, hit));
    EXPECT_NEAR(hit.t, 10 + std::sqrt(0.99), 1e-9);
    ASSERT_TRUE(region->first_boundary({{5, 0, 10}, {0, 0, -1}, 1e9, {}, {}}, 0, hit));
    EXPECT_NEAR(hit.t, 10, 1e-12);
}

}  // namespace
}  // namespace cardioid::csg
