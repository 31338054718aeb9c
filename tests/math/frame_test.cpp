#include "rt_core/math/frame.hpp"

#include <gtest/gtest.h>

#include "rt_core/math/sampler.hpp"
#include "rt_core/math/sampling.hpp"

namespace cardioid {
namespace {

void expect_orthonormal(Vec3 n) {
    const Frame frame(n);
    for (const Vec3 axis : {frame.s, frame.t, frame.n}) EXPECT_NEAR(length(axis), 1, 1e-6F);
    EXPECT_NEAR(dot(frame.s, frame.t), 0, 1e-6F);
    EXPECT_NEAR(dot(frame.s, n), 0, 1e-6F);
    EXPECT_NEAR(dot(frame.t, n), 0, 1e-6F);
    EXPECT_NEAR(dot(cross(frame.s, frame.t), n), 1, 1e-6F);
}

TEST(Frame, IsOrthonormalAndRightHandedAroundEveryNormal) {
    for (std::uint32_t i = 0; i < 10'000; ++i)
        expect_orthonormal(sample_sphere(Sampler(1, Purpose::test, 0, i).next2()));
}

TEST(Frame, HasNoHoleAtThePoles) {
    for (const float z : {1.0F, -1.0F})
        for (const float x : {0.0F, -0.0F, 1e-4F, -1e-7F, 1e-20F}) expect_orthonormal(normalize(Vec3{x, x / 3, z}));
    for (const float z : {0.0F, -0.0F, 1e-30F, -1e-30F}) expect_orthonormal({0.6F, -0.8F, z});
}

TEST(Frame, TakesDirectionsThereAndBack) {
    const Frame frame(normalize(Vec3{0.3F, -0.5F, -0.7F}));
    const Vec3 v{0.1F, 2, -3};
    EXPECT_NEAR(length(frame.to_world(frame.to_local(v)) - v), 0, 1e-6F);
    EXPECT_NEAR(length(frame.to_local(frame.n) - Vec3{0, 0, 1}), 0, 1e-6F);
}

}  // namespace
}  // namespace cardioid
