#include "photon/map/kernel.hpp"

#include <gtest/gtest.h>

namespace cardioid::photon::test {
namespace {

constexpr Kernel kernels[] = {Kernel::box, Kernel::cone, Kernel::gauss, Kernel::epanechnikov, Kernel::biweight};

/// The mean over the disc of weight(t^2), by the midpoint rule in t^2, which is even over a disc.
template <class Weight>
double mean_over_disc(const Weight& weight) {
    constexpr int n = 100'000;
    double sum = 0;
    for (int i = 0; i < n; ++i) sum += double{weight(static_cast<float>((i + 0.5) / n))};
    return sum / n;
}

TEST(Kernel, OfEveryKindHasTheMeanOneOverItsDisc) {
    for (const Kernel kernel : kernels)
        EXPECT_NEAR(mean_over_disc([&](float t2) { return kernel_weight(kernel, t2); }), 1, 1e-5);
}

TEST(Kernel, IsNowhereNegativeAndFallsOutwards) {
    for (const Kernel kernel : kernels)
        for (float t2 = 0, last = 10; t2 <= 1; t2 += 0x1p-7F) {
            const float w = kernel_weight(kernel, t2);
            EXPECT_GE(w, 0);
            EXPECT_LE(w, last);
            last = w;
        }
}

TEST(Kernel, OfGaussWithThePrintedConstantWouldLoseNearlyHalf) {
    const double scale = 0.918 / 1.728309;
    EXPECT_NEAR(scale * mean_over_disc([](float t2) { return kernel_weight(Kernel::gauss, t2); }), 0.531155, 1e-5);
}

TEST(Kernel, OfAConeHasTheMeanOneForEverySlope) {
    for (const float k : {1.0F, 1.1F, 1.5F, 4.0F})
        EXPECT_NEAR(mean_over_disc([&](float t2) { return cone_weight(k, t2); }), 1, 1e-5);
}

}  // namespace
}  // namespace cardioid::photon::test
