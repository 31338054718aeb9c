#include "photon/map/kernel.hpp"

#include <cmath>

namespace cardioid::photon {

namespace {

constexpr float gauss_alpha = 1.728309F, gauss_beta = 1.953F;
constexpr float gauss_depth = 0.858152F;  ///< 1 - exp(-beta)

}  // namespace

float cone_weight(float k, float t2) noexcept { return (1 - std::sqrt(t2) / k) / (1 - 2 / (3 * k)); }

float kernel_weight(Kernel kernel, float t2) noexcept {
    switch (kernel) {
        case Kernel::box:
            return 1;
        case Kernel::cone:
            return cone_weight(1, t2);
        case Kernel::gauss:
            return gauss_alpha * (1 - (1 - std::exp(-gauss_beta * t2 / 2)) / gauss_depth);
        case Kernel::epanechnikov:
            return 2 * (1 - t2);
        case Kernel::biweight:
            return 3 * (1 - t2) * (1 - t2);
    }
    return 1;
}

}  // namespace cardioid::photon
