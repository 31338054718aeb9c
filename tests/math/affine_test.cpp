#include "rt_core/math/affine.hpp"

#include <gtest/gtest.h>

namespace cardioid {
namespace {

Affine skewed() { return {{Vec3d{1, 2, 0.5}, {-0.3, 1.5, 0.1}, {0.2, 0, -2}}, {5, -6, 7}}; }

TEST(Affine, InverseTakesBack) {
    const Affine there = skewed(), back = there.inverse();
    for (const Vec3d p : {Vec3d{0, 0, 0}, {1, 2, 3}, {-100, 5, 0.01}})
        EXPECT_NEAR(length(back.point(there.point(p)) - p), 0, 1e-12 * (1 + length(p)));
}

TEST(Affine, ProductAppliesTheRightOneFirst) {
    const Affine product = skewed() * Affine::translation({1, 1, 1}) * Affine::scaling({2, 3, 4});
    const Vec3d p{0.5, -1, 2};
    EXPECT_NEAR(length(product.point(p) - skewed().point({2, -2, 9})), 0, 1e-12);
}

TEST(Affine, CarriesNormalsByTheTransposedInverse) {
    const Affine a = skewed(), to_local = a.inverse();
    const Vec3d u{1, 2, 3}, v{-2, 0.5, 1}, normal = cross(u, v);
    const Vec3d carried = to_local.transposed_vector(normal);
    EXPECT_NEAR(dot(carried, a.vector(u)), 0, 1e-12);
    EXPECT_NEAR(dot(carried, a.vector(v)), 0, 1e-12);
}

TEST(Affine, BoxHoldsTheImageOfABox) {
    const Box3d image = skewed().box({{-1, -2, -3}, {1, 2, 3}});
    for (int i = 0; i < 27; ++i)
        EXPECT_TRUE(image.padded(1e-12).contains(
            skewed().point({double(i % 3 - 1), 2.0 * (i / 3 % 3 - 1), 3.0 * (i / 9 - 1)})));
}

}  // namespace
}  // namespace cardioid
