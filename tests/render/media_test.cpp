#include "rt_core/render/commit/media.hpp"

#include <gtest/gtest.h>

#include "scene_kit.hpp"

namespace cardioid {
namespace {

using test::SceneKit;

/// z of every boundary a ray from below meets, with the media before and behind it.
struct Crossing {
    double z;
    float before, behind;
};

std::vector<Crossing> crossings(const CommittedScene& scene, Vec3d o = {0.01, 0.02, -10}) {
    std::vector<Crossing> out;
    Ray ray{o, {0, 0, 1}, Box3d::infinity, {}, {}};
    while (out.size() < 20) {
        const Hit hit = scene.intersect(ray);
        if (!hit.found()) break;
        const SurfacePoint point = scene.surface(ray, hit);
        const bool entering = point.ng.z < 0;
        out.push_back(
            {point.p.z, (entering ? point.front : point.back)->ior, (entering ? point.back : point.front)->ior});
        ray = point.ray({0, 0, 1});
    }
    return out;
}

void expect_crossings(const CommittedScene& scene, const std::vector<Crossing>& wanted) {
    const std::vector<Crossing> found = crossings(scene);
    ASSERT_EQ(found.size(), wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        EXPECT_NEAR(found[i].z, wanted[i].z, 1e-9) << i;
        EXPECT_EQ(found[i].before, wanted[i].before) << i;
        EXPECT_EQ(found[i].behind, wanted[i].behind) << i;
    }
}

struct GlassKit : SceneKit {
    std::uint32_t glass = material("glass", "dielectric", {{"ior", {1.5}}});
    /// Another name for the same glass, so that solids of the two are not made one.
    std::uint32_t equal_glass = material("equal glass", "dielectric", {{"ior", {1.5}}});
    std::uint32_t water = material("water", "dielectric", {{"ior", {1.25}}});
    std::uint32_t slab(double lo, double hi, std::uint32_t m) { return box({-1, -1, lo}, {1, 1, hi}, m); }
};

TEST(Media, AreKnownOnBothSidesOfAPane) {
    GlassKit kit;
    kit.root(kit.slab(0, 1, kit.glass));
    const CommittedScene scene = kit.commit();
    expect_crossings(scene, {{0, 1, 1.5F}, {1, 1.5F, 1}});
    EXPECT_EQ(scene.medium_at({0, 0, 0.5})->ior, 1.5F);
    EXPECT_EQ(scene.medium_at({0, 0, 1.5})->ior, 1);
}

TEST(Media, OfTwoEqualGlassesThatOverlapShowNoBoundaryBetweenThem) {
    GlassKit kit;
    kit.root(kit.slab(0, 2, kit.glass));
    kit.root(kit.slab(1, 3, kit.equal_glass));
    expect_crossings(kit.commit(), {{0, 1, 1.5F}, {3, 1.5F, 1}});
}

TEST(Media, OfTwoEqualGlassesThatTouchShowNoBoundaryBetweenThem) {
    GlassKit kit;
    kit.root(kit.slab(0, 2, kit.glass));
    kit.root(kit.slab(2, 3, kit.equal_glass));
    expect_crossings(kit.commit(), {{0, 1, 1.5F}, {3, 1.5F, 1}});
}

TEST(Media, ThatTouchMeetAtOneBoundary) {
    GlassKit kit;
    kit.root(kit.slab(0, 2, kit.glass));
    kit.root(kit.slab(2, 3, kit.water));
    expect_crossings(kit.commit(), {{0, 1, 1.5F}, {2, 1.5F, 1.25F}, {3, 1.25F, 1}});
}

TEST(Media, AreThoseOfTheEarlierSolidWhereTwoOverlap) {
    GlassKit kit;
    kit.root(kit.slab(0, 2, kit.glass));
    kit.root(kit.slab(1, 3, kit.water));
    expect_crossings(kit.commit(), {{0, 1, 1.5F}, {2, 1.5F, 1.25F}, {3, 1.25F, 1}});
}

TEST(Media, AreThoseOfTheHigherPriorityWhereTwoOverlap) {
    GlassKit kit;
    const std::uint32_t ice = kit.material("ice", "dielectric", {{"ior", {1.3125}}, {"priority", {5}}});
    kit.root(kit.slab(0, 3, kit.water));
    kit.root(kit.slab(1, 2, ice));
    expect_crossings(kit.commit(), {{0, 1, 1.25F}, {1, 1.25F, 1.3125F}, {2, 1.3125F, 1.25F}, {3, 1.25F, 1}});
}

TEST(Media, HideASolidWithinAnotherOfHigherRank) {
    GlassKit kit;
    kit.root(kit.slab(0, 3, kit.glass));
    kit.root(kit.slab(1, 2, kit.water));
    const CommittedScene scene = kit.commit();
    expect_crossings(scene, {{0, 1, 1.5F}, {3, 1.5F, 1}});
    // What is hidden throws no shadow either.
    EXPECT_FALSE(scene.occluded({{0, 0, 0.5}, {0, 0, 1}, 2, {}, {}}));
    EXPECT_TRUE(scene.occluded({{0, 0, 0.5}, {0, 0, 1}, 3, {}, {}}));
    EXPECT_EQ(scene.transmittance({{0, 0, 0.5}, {0, 0, 1}, 2, {}, {}}), Rgb(1));
}

TEST(Media, LeaveOpaqueSolidsInGlassVisible) {
    GlassKit kit;
    kit.root(kit.slab(0, 3, kit.glass));
    kit.root(kit.ball({0, 0, 1.5}, 0.5, 0));
    const CommittedScene scene = kit.commit();
    const SurfacePoint point = test::seen(scene, {0, 0, 0.5}, {0, 0, 1});
    EXPECT_NEAR(point.p.z, 1, 1e-9);
    EXPECT_EQ(point.front->ior, 1.5F);
}

TEST(Media, LeaveAFilterInAirVisible) {
    GlassKit kit;
    const std::uint32_t foil = kit.material("foil", "filter", {{"transmittance", {0.5}}});
    const std::uint32_t other = kit.material("other", "filter", {{"transmittance", {0.25}}});
    kit.root(kit.slab(0, 1, foil));
    kit.root(kit.slab(0.5, 2, other));
    EXPECT_EQ(crossings(kit.commit()).size(), 4U);
}

}  // namespace
}  // namespace cardioid
