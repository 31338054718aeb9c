#include <gtest/gtest.h>

#include "tests/csg/models.hpp"

namespace cardioid::csg {
namespace {

using test::box_leaf;
using test::Random;

std::size_t boundaries_of(const SolidTree& tree, const Ray& ray) {
    std::vector<Boundary> all;
    if (const auto region = test::whole(tree, true)) region->boundaries(ray, all);
    return all.size();
}

/// Rays from all around through the middle of [0, 10]^3.
std::vector<Ray> rays_around(unsigned seed, int count) {
    Random random(seed);
    std::vector<Ray> out;
    for (int i = 0; i < count; ++i) {
        const Vec3d d = random.direction();
        out.push_back({random.point(3, 7) - d * 40.0, d, 1e9, {}, {}});
    }
    return out;
}

TEST(Weld, TouchingPartsHaveNoFaceBetweenThem) {
    for (const double gap : {0.0, 1e-13, 1e-8, 1e-6, -1e-6}) {
        SolidTree tree;
        tree.roots = {tree.add_node(SolidOp::unite, {tree.add_leaf(box_leaf({0, 0, 0}, {10, 10, 5})),
                                                     tree.add_leaf(box_leaf({0, 0, 5 + gap}, {10, 10, 5}))})};
        for (const Ray& ray : rays_around(1, 2000)) ASSERT_EQ(boundaries_of(tree, ray), 2U) << gap;
    }
}

TEST(Weld, ACutterFlushWithAFaceLeavesNoSkin) {
    for (const double gap : {0.0, 1e-13, 1e-8, 1e-6, -1e-6}) {
        SolidTree tree;  // a well through the whole block: its floor and its mouth are flush
        tree.roots = {tree.add_node(SolidOp::subtract, {tree.add_leaf(box_leaf({0, 0, 0}, {10, 10, 10})),
                                                        tree.add_leaf(box_leaf({2, 2, -gap}, {6, 6, 10 + 2 * gap}))})};
        Random random(2);
        for (int i = 0; i < 2000; ++i) {
            const Vec3d o{random(3, 7), random(3, 7), 30};
            const Vec3d d = normalize(Vec3d{random(-0.02, 0.02), random(-0.02, 0.02), -1});
            ASSERT_EQ(boundaries_of(tree, {o, d, 1e9, {}, {}}), 0U) << gap;
        }
    }
}

TEST(Weld, PartsAHundredThousandthApartStayApart) {
    SolidTree tree;
    const double gap = 1e-5 * std::sqrt(300.0) * 1.01;
    tree.roots = {tree.add_node(SolidOp::unite, {tree.add_leaf(box_leaf({0, 0, 0}, {10, 10, 5})),
                                                 tree.add_leaf(box_leaf({0, 0, 5 + gap}, {10, 10, 5 - gap}))})};
    const Ray ray{{5, 5, -20}, normalize(Vec3d{0.01, 0.02, 1}), 1e9, {}, {}};
    EXPECT_EQ(boundaries_of(tree, ray), 4U);
}

TEST(Weld, CornersThatOnlyTouchStay) {
    SolidTree tree;  // two blocks that share an edge
    tree.roots = {tree.add_node(SolidOp::unite, {tree.add_leaf(box_leaf({0, 0, 0}, {5, 5, 10})),
                                                 tree.add_leaf(box_leaf({5, 5, 0}, {5, 5, 10}))})};
    EXPECT_EQ(boundaries_of(tree, {{-10, 2.5, 5}, {1, 0, 0}, 1e9, {}, {}}), 2U);
    EXPECT_EQ(boundaries_of(tree, {{-5, -5, 5}, normalize(Vec3d{1, 1, 0}), 1e9, {}, {}}), 2U);
}

/// A model all of whose faces coincide with others: blocks of a grid, united, minus blocks of the same grid.
TEST(Weld, AGridOfCoincidingFacesIsRightFromEveryDirection) {
    Random random(11);
    SolidTree tree;
    std::vector<std::uint32_t> parts, cutters;
    std::vector<int> filled(1000, 0);
    for (int i = 0; i < 1000; ++i) {
        const Vec3d at{static_cast<double>(i % 10), static_cast<double>(i / 10 % 10), static_cast<double>(i / 100)};
        const int kind = random.whole(0, 3);
        if (kind == 0) continue;
        // Sizes and places as six digits would have them.
        const Vec3d noise = random.point(-2e-6, 2e-6);
        parts.push_back(tree.add_leaf(box_leaf(at + noise, {1, 1, 1})));
        if (kind == 1) cutters.push_back(tree.add_leaf(box_leaf(at - noise, {1, 1, 1})));
        filled[static_cast<std::size_t>(i)] = kind > 1;
    }
    tree.roots = {tree.add_node(SolidOp::subtract,
                                {tree.add_node(SolidOp::unite, parts), tree.add_node(SolidOp::unite, cutters)})};
    const auto region = test::whole(tree, true);
    std::vector<Boundary> all;
    int compared = 0;
    for (const Ray& ray : rays_around(12, 3000)) {
        region->boundaries(ray, all);
        // The cells' own walk: middle of each piece of the ray between grid planes.
        std::vector<double> cuts;
        for (int axis = 0; axis < 3; ++axis)
            for (int k = 0; k <= 10; ++k) cuts.push_back((k - ray.o[axis]) / ray.d[axis]);
        std::sort(cuts.begin(), cuts.end());
        std::size_t wanted = 0;
        bool was = false;
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
            if (cuts[i + 1] - cuts[i] < 1e-3) goto next_ray;  // near an edge, where the noise decides
            const Vec3d p = ray.o + ray.d * (0.5 * (cuts[i] + cuts[i + 1]));
            const auto cell = [](double x) { return static_cast<int>(std::floor(x)); };
            const bool in_grid = Box3d{{0, 0, 0}, {10, 10, 10}}.contains(p);
            const bool is = in_grid && filled[static_cast<std::size_t>(cell(p.x) + 10 * cell(p.y) + 100 * cell(p.z))];
            wanted += is != was;
            was = is;
        }
        wanted += was;
        ASSERT_EQ(all.size(), wanted);
        ++compared;
    next_ray:;
    }
    EXPECT_GT(compared, 500);
}

}  // namespace
}  // namespace cardioid::csg
