#include "csg/shapes/degrees.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace cardioid::csg {

namespace {

/// |degrees| <= 45.
SinCos of_reduced(double degrees) {
    const double size = std::abs(degrees);
    SinCos out{std::sin(size * (std::numbers::pi / 180)), std::cos(size * (std::numbers::pi / 180))};
    if (size == 30) out = {0.5, std::numbers::sqrt3 / 2};
    if (size == 45) out = {std::numbers::sqrt2 / 2, std::numbers::sqrt2 / 2};
    if (degrees < 0) out.sin = -out.sin;
    return out;
}

}  // namespace

SinCos sin_cos_deg(double degrees) {
    int quarter = 0;
    SinCos out = of_reduced(std::remquo(degrees, 90.0, &quarter));
    if (quarter & 1) out = {out.cos, -out.sin};
    if (quarter & 2) out = {-out.sin, -out.cos};
    return {out.sin + 0.0, out.cos + 0.0};  // no negative zeros
}

}  // namespace cardioid::csg
