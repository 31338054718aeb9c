#include <gtest/gtest.h>

#include "csg/coincidence.hpp"
#include "csg/compile.hpp"
#include "csg/measure.hpp"
#include "csg/region/weld_counts.hpp"

// The search for faces near each other.
namespace {

using namespace cardioid;
using Kind = csg::NearFaces::Kind;

std::uint32_t box(SolidTree& tree, Vec3d lo, Vec3d size) {
    return tree.add_leaf({LeafKind::box, Affine::translation(lo) * Affine::scaling(size)});
}

/// Two cubes of side 10, the second beside the first.
SolidTree neighbours(double gap, double scale) {
    SolidTree tree;
    const double side = 10 * scale;
    tree.roots = {box(tree, {0, 0, 0}, {side, side, side}), box(tree, {side + gap * scale, 0, 0}, {side, side, side})};
    return tree;
}

TEST(NearFaces, TouchingCubesHaveOneFaceInCommonAtAnyScale) {
    for (const double scale : {1e-6, 1.0, 1e6}) {
        const auto report = csg::find_near_faces(neighbours(0, scale), true, 1e-5);
        ASSERT_EQ(report.pairs.size(), 1U) << scale;
        EXPECT_EQ(report.pairs[0].kind, Kind::coincident);
        EXPECT_EQ(report.pairs[0].a, 0U);
        EXPECT_EQ(report.pairs[0].b, 1U);
        EXPECT_NEAR(report.pairs[0].where.x, 10 * scale, 1e-6 * scale);
        // Every line of the x direction that is not lost beside the face.
        EXPECT_GT(report.pairs[0].lines, 0.95 * report.grid * report.grid);
    }
}

TEST(NearFaces, AGapIsCoincidentASliverOrNothingByItsWidth) {
    const auto kinds = [](double gap, bool six_digits) {
        std::vector<Kind> out;
        for (const auto& pair : csg::find_near_faces(neighbours(gap, 1), six_digits, 1e-5).pairs)
            out.push_back(pair.kind);
        return out;
    };
    EXPECT_EQ(kinds(1e-5, true), std::vector{Kind::coincident});
    EXPECT_EQ(kinds(1e-5, false), std::vector{Kind::thin_gap});
    EXPECT_EQ(kinds(1e-4, true), std::vector{Kind::thin_gap});
    EXPECT_TRUE(kinds(1e-3, true).empty());
}

TEST(NearFaces, ASkinThatACutterLeavesIsMeasuredAlongItsNormal) {
    SolidTree tree;
    const std::uint32_t cube = box(tree, {0, 0, 0}, {10, 10, 10});
    const std::uint32_t cutter = box(tree, {-1, -1, -1}, {12, 12, 10.9999});
    tree.roots = {tree.add_node(SolidOp::subtract, {cube, cutter})};
    const auto report = csg::find_near_faces(tree, true, 1e-5);
    ASSERT_EQ(report.pairs.size(), 1U);
    EXPECT_EQ(report.pairs[0].kind, Kind::thin_solid);
    EXPECT_NEAR(report.pairs[0].distance, 1e-4, 1e-9);
}

TEST(NearFaces, CuttersThatShareAPlaneWhereNothingIsAreOfNoInterest) {
    SolidTree tree;
    const std::uint32_t cube = box(tree, {0, 0, 0}, {10, 10, 10});
    const std::uint32_t first = box(tree, {-1, -1, 5}, {6, 12, 15}), second = box(tree, {5, -1, 5}, {6, 12, 15});
    tree.roots = {tree.add_node(SolidOp::subtract, {cube, first, second})};
    const auto pairs = csg::find_near_faces(tree, true, 1e-5).pairs;
    EXPECT_TRUE(pairs.empty());
}

TEST(NearFaces, NothingIsFoundInNothing) {
    EXPECT_TRUE(csg::find_near_faces({}, true, 1e-5).pairs.empty());
    SolidTree unbounded;
    unbounded.roots = {unbounded.add_leaf({LeafKind::half_space, {}})};
    EXPECT_TRUE(csg::find_near_faces(unbounded, true, 1e-5).pairs.empty());
}

TEST(WeldCounts, CountEachCrossingOfFacesThatCoincide) {
    const auto crossings = [](double gap) {
        const auto whole = csg::compile_whole(neighbours(gap, 1), true);
        const csg::WeldCounts before = csg::weld_counts();
        EXPECT_EQ(csg::inside_spans(*whole, {-5, 5, 5}, {1, 0, 0}, 40).size(), gap > 1e-4 ? 2U : 1U);
        const csg::WeldCounts after = csg::weld_counts();
        return std::pair{after.exact - before.exact, after.welded - before.welded};
    };
    EXPECT_EQ(crossings(0), (std::pair<std::uint64_t, std::uint64_t>{1, 0}));
    EXPECT_EQ(crossings(1e-5), (std::pair<std::uint64_t, std::uint64_t>{0, 1}));
    EXPECT_EQ(crossings(1e-2), (std::pair<std::uint64_t, std::uint64_t>{0, 0}));
}

}  // namespace
