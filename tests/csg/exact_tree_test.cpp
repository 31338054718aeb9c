#include <atomic>
#include <cmath>
#include <gtest/gtest.h>
#include <omp.h>

#include "csg/exact/boolean/boolean_plan.hpp"
#include "csg/exact/evaluate_mesh.hpp"
#include "csg/exact/tessellate.hpp"
#include "csg/shapes/mesh_repair.hpp"
#include "rt_core/api/error.hpp"
#include "tests/csg/models.hpp"

// Booleans whose parts stay exact from node to node.
namespace cardioid::csg {
namespace {

using test::box_leaf;
using test::Random;

/// A box turned about two axes, so that no number of it is short.
Leaf turned_box(Random& random) {
    const double a = random(0, 3), b = random(0, 3);
    const Affine about_z{{Vec3d{std::cos(a), -std::sin(a), 0}, {std::sin(a), std::cos(a), 0}, {0, 0, 1}}, {}};
    const Affine about_x{{Vec3d{1, 0, 0}, {0, std::cos(b), -std::sin(b)}, {0, std::sin(b), std::cos(b)}}, {}};
    Leaf leaf = box_leaf({-1.5, -1.5, -1.5}, {3, 3, 3});
    leaf.to_world = Affine::translation(random.point(-1, 1)) * about_z * about_x * leaf.to_world;
    return leaf;
}

double exact_volume(const SolidTree& tree, std::uint32_t node) {
    const TriangleMesh mesh = evaluate_mesh(tree, node, 0);
    EXPECT_TRUE(mesh.closed || mesh.triangles.empty());
    return volume(mesh);
}

TEST(ExactTree, UnionAndIntersectionEncloseAsMuchAsBothPartsOfTurnedBoxes) {
    for (unsigned seed = 1; seed <= 8; ++seed) {
        Random random(seed);
        SolidTree tree;
        const auto leaf = [&] { return turned_box(random); };
        const std::uint32_t a = test::random_tree(tree, random, 1, leaf), b = test::random_tree(tree, random, 1, leaf);
        const double parts = exact_volume(tree, a) + exact_volume(tree, b);
        const double both = exact_volume(tree, tree.add_node(SolidOp::unite, {a, b})) +
                            exact_volume(tree, tree.add_node(SolidOp::intersect, {a, b}));
        EXPECT_NEAR(both, parts, 1e-12 * (1 + parts)) << seed;
    }
}

/// What is cut off by a face and put back by the same turned face leaves no gap: one box again.
TEST(ExactTree, PartsCutByATurnedFaceFitTogetherAgain) {
    Random random(5);
    SolidTree tree;
    const auto box = [&] { return tree.add_leaf(box_leaf({-1, -1, -1}, {2, 2, 2})); };
    const Leaf knife = turned_box(random);
    const std::uint32_t outside = tree.add_node(SolidOp::subtract, {box(), tree.add_leaf(knife)});
    const std::uint32_t inside = tree.add_node(SolidOp::intersect, {box(), tree.add_leaf(knife)});
    const std::uint32_t whole = tree.add_node(SolidOp::unite, {outside, inside});
    EXPECT_NEAR(exact_volume(tree, whole), 8, 1e-14 * 8);
    EXPECT_EQ(exact_volume(tree, tree.add_node(SolidOp::subtract, {box(), whole})), 0);
}

TEST(ExactTree, ATriangleWithoutAreaOpensNoMesh) {
    // A tetrahedron; an edge of it has a middle corner, which a flat triangle joins to the other face.
    TriangleMesh mesh{{{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {0, 0, 3}, {1, 0, 0}}, {}, true};
    mesh.triangles = {{0, 2, 1}, {0, 4, 3}, {4, 1, 3}, {0, 1, 4}, {0, 3, 2}, {1, 2, 3}};
    ASSERT_TRUE(weld(mesh).closed());
    SolidTree tree;
    const std::uint32_t solid = tree.add_leaf({.kind = LeafKind::mesh, .data = tree.add_mesh(mesh)});
    const std::uint32_t above = tree.add_leaf(box_leaf({-1, -1, 1}, {9, 9, 9}));
    EXPECT_NEAR(exact_volume(tree, tree.add_node(SolidOp::intersect, {solid, above})), 8.0 / 6, 1e-15);
    EXPECT_NEAR(exact_volume(tree, tree.add_node(SolidOp::subtract, {solid, above})), 19.0 / 6, 1e-14);
}

/// A surface that runs through itself is no business of parts that it does not touch: it stays as it is.
TEST(ExactTree, PartsApartAreTakenAsTheyAre) {
    SolidTree tree;
    TriangleMesh crossed = tessellate(tree, box_leaf({0, 0, 0}, {1, 1, 1}), 0);
    const TriangleMesh other = tessellate(tree, box_leaf({0.5, 0.5, 0.5}, {1, 1, 1}), 0);
    const auto first = static_cast<std::uint32_t>(crossed.vertices.size());
    crossed.vertices.insert(crossed.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (const auto& [a, b, c] : other.triangles) crossed.triangles.push_back({a + first, b + first, c + first});
    const std::uint32_t solid = tree.add_leaf({.kind = LeafKind::mesh, .data = tree.add_mesh(crossed)});
    const std::uint32_t far = tree.add_leaf(box_leaf({5, 0, 0}, {1, 1, 1}));
    const std::uint32_t beside = tree.add_leaf(box_leaf({5.5, 0, 0}, {1, 1, 1}));
    EXPECT_EQ(exact_volume(tree, tree.add_node(SolidOp::unite, {far, solid, beside})), 3.5);
}

TEST(ExactTree, TheMeshIsTheSameForAnyNumberOfThreads) {
    Random random(3);
    SolidTree tree;
    const auto leaf = [&] { return turned_box(random); };
    const std::uint32_t node = test::random_tree(tree, random, 2, leaf);
    const int before = omp_get_max_threads();
    omp_set_num_threads(1);
    const TriangleMesh one = evaluate_mesh(tree, node, 0);
    omp_set_num_threads(4);
    const TriangleMesh four = evaluate_mesh(tree, node, 0);
    omp_set_num_threads(before);
    EXPECT_FALSE(one.triangles.empty());
    EXPECT_EQ(one.vertices, four.vertices);
    EXPECT_EQ(one.triangles, four.triangles);
}

/// Wants to stop once so much is done.
class Impatient final : public Progress {
public:
    explicit Impatient(double share) : share_(share) {}
    void update(double share) override { stop_ = stop_ || share >= share_; }
    [[nodiscard]] bool interrupted() const noexcept override { return stop_; }

private:
    double share_;
    std::atomic<bool> stop_{false};
};

TEST(ExactTree, EvaluationEndsWhereTheUserWantsToStop) {
    Random random(3);
    SolidTree tree;
    const std::uint32_t a = tree.add_leaf(turned_box(random)), b = tree.add_leaf(turned_box(random));
    const std::uint32_t node = tree.add_node(SolidOp::unite, {a, b});
    Impatient after_leaves(0.5), never(2);  // the union weighs as much as its two leaves
    try {
        evaluate_mesh(tree, node, 0, &after_leaves);
        FAIL() << "was not stopped";
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), ErrorCode::interrupted);
    }
    EXPECT_FALSE(evaluate_mesh(tree, node, 0, &never).triangles.empty());
}

TEST(BooleanPlan, UnionsOfUnionsAndWhatIsTakenAwayAreOneStep) {
    SolidTree tree;
    std::vector<std::uint32_t> l(6);
    for (std::uint32_t& leaf : l) leaf = tree.add_leaf(box_leaf({0, 0, 0}, {1, 1, 1}));
    const auto wrap = [&](std::uint32_t node) { return tree.add_node(SolidOp::unite, {node}); };
    const std::uint32_t first = tree.add_node(SolidOp::subtract, {l[0], l[1]});
    const std::uint32_t pair = tree.add_node(SolidOp::unite, {l[3], wrap(tree.add_node(SolidOp::unite, {l[4], l[5]}))});
    const std::vector<PlannedBoolean> plan =
        plan_booleans(tree, wrap(tree.add_node(SolidOp::subtract, {wrap(first), l[2], wrap(pair)})));
    ASSERT_EQ(plan.size(), 7U);
    EXPECT_EQ(plan.back().op, SolidOp::subtract);
    ASSERT_EQ(plan.back().parts.size(), 6U);
    EXPECT_EQ(plan[plan.back().parts[0]].leaf, 0U);
    EXPECT_EQ(plan.back().height, 1U);
}

TEST(BooleanPlan, WhatTwoStepsNeedStaysAStep) {
    SolidTree tree;
    const auto leaf = [&] { return tree.add_leaf(box_leaf({0, 0, 0}, {1, 1, 1})); };
    const std::uint32_t shared = tree.add_node(SolidOp::unite, {leaf(), leaf()});
    const std::uint32_t one = tree.add_node(SolidOp::unite, {shared, leaf()});
    const std::uint32_t other = tree.add_node(SolidOp::subtract, {leaf(), shared});
    const std::vector<PlannedBoolean> plan = plan_booleans(tree, tree.add_node(SolidOp::intersect, {one, other}));
    EXPECT_EQ(plan.size(), 8U);  // four leaves, four booleans
    EXPECT_EQ(plan.back().height, 3U);
}

TEST(BooleanPlan, AChainOfAHundredThousandIsOneStep) {
    SolidTree tree;
    std::uint32_t node = tree.add_leaf(box_leaf({0, 0, 0}, {1, 1, 1}));
    for (int i = 0; i < 100'000; ++i)
        node = tree.add_node(SolidOp::unite, {tree.add_leaf(box_leaf({0, 0, 0}, {1, 1, 1})), node});
    EXPECT_EQ(plan_booleans(tree, node).back().parts.size(), 100'001U);
}

}  // namespace
}  // namespace cardioid::csg
