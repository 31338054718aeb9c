#include "rt_core/render/commit/seen_box.hpp"

#include <gtest/gtest.h>
#include <numbers>

namespace cardioid {
namespace {

constexpr Box3d box{{-1, -2, 0}, {1, 2, 0.5}};

/// Whether a ray meets the box, by slabs.
bool meets(const Box3d& of, Vec3d from, Vec3d d) {
    double t0 = 0, t1 = 1e300;
    for (int axis = 0; axis < 3; ++axis) {
        const double a = (of.lo[axis] - from[axis]) / d[axis], b = (of.hi[axis] - from[axis]) / d[axis];
        t0 = std::max(t0, std::min(a, b)), t1 = std::min(t1, std::max(a, b));
    }
    return t0 <= t1;
}

/// Seeing one, two and three faces, from near and from afar, and all but in a face's plane.
const Vec3d places[] = {{0.3, 0.1, 2}, {5, 0, 0.2}, {3, 4, -2}, {40, -30, 20}, {0.2, 0.2, 0.501}, {90, 0.3, 0.5001}};

TEST(SeenBox, DrawsDirectionsThatMeetItWithTheDensityItTells) {
    for (const Vec3d from : places) {
        const SeenBox seen(box, from);
        ASSERT_TRUE(seen.in_sight());
        for (std::uint32_t i = 0; i < 1000; ++i) {
            Sampler sampler(1, Purpose::test, 0, i);
            const SeenBox::Direction way = seen.sample(sampler.next2());
            EXPECT_NEAR(length(way.d), 1, 1e-12);
            EXPECT_TRUE(meets(box.padded(1e-9), from, way.d));
            const double pdf = seen.pdf(way.d);
            if (pdf > 0) EXPECT_NEAR(pdf, way.pdf, 1e-6 * pdf);  // rounding may put it past an edge
        }
    }
}

/// Means over drawn directions are integrals over all that meet the box: of 1 and of a lopsided function.
TEST(SeenBox, WeighsDirectionsWithoutBias) {
    const auto f = [](Vec3d d) { return 1 + 0.9 * d.x + 0.5 * d.y * d.z; };
    constexpr std::uint32_t n = 1 << 16, lines = 1 << 20;
    for (const Vec3d from : places) {
        const SeenBox seen(box, from);
        // All directions within the cone around the box, each counted where it meets it.
        const Vec3d way = box.centre() - from;
        const double radius = box.diagonal() / 2, d2 = dot(way, way);
        const double cone = d2 > radius * radius ? 1 - std::sqrt(1 - radius * radius / d2) : 2;
        const Frame frame(Vec3(normalize(way)));
        double wanted = 0, found = 0;
        for (std::uint32_t i = 0; i < lines; ++i) {
            Sampler sampler(2, Purpose::test, 0, i);
            const Vec3 local = sample_cone(sampler.next2(), static_cast<float>(cone));
            const Vec3d d(cone < 2 ? frame.to_world(local) : local);
            if (meets(box, from, d)) wanted += f(d) * 2 * std::numbers::pi * cone / lines;
        }
        for (std::uint32_t i = 0; i < n; ++i) {
            Sampler sampler(3, Purpose::test, 0, i);
            const SeenBox::Direction drawn = seen.sample(sampler.next2());
            found += f(drawn.d) / drawn.pdf / n;
        }
        EXPECT_NEAR(found, wanted, 5e-3 * wanted) << from.x << " " << from.y << " " << from.z;
    }
}

TEST(SeenBox, HasNoDensityWhereItIsNot) {
    const SeenBox seen(box, {0, 0, 3});
    EXPECT_EQ(seen.pdf({0, 0, 1}), 0);
    EXPECT_EQ(seen.pdf(normalize(Vec3d{2, 0, -2.5})), 0);
    EXPECT_GT(seen.pdf({0, 0, -1}), 0);
}

TEST(SeenBox, IsOutOfSightFromInside) { EXPECT_FALSE(SeenBox(box, {0, 0, 0.2}).in_sight()); }

TEST(SeenBox, MayBeFlat) {
    const SeenBox seen({{-1, -1, 0}, {1, 1, 0}}, {0, 0, 1});
    ASSERT_TRUE(seen.in_sight());
    // The faces of a cube fill the sphere.
    EXPECT_NEAR(1 / seen.pdf({0, 0, -1}), 4 * std::numbers::pi / 6, 1e-12);
}

}  // namespace
}  // namespace cardioid
