#pragma once
#include <vector>

#include "rt_core/api/world.hpp"

namespace cardioid::test {

/// What a ray of light does at a smooth surface.
enum class Turn { reflect, refract };

/// A ray that is followed through smooth surfaces by the hooks that rendering uses.
struct LightRay {
    Vec3d o, d;
    double share = 1;        ///< of its light that went this way
    double last_cosine = 0;  ///< to the normal of the last surface, on the side it came from
    bool gone = false;       ///< met nothing, or could not turn that way
};

/// Follows the ray over as many surfaces as there are turns. The share is by Bsdf::albedo, each turn by Bsdf::sample.
LightRay follow(const World& world, Vec3d o, Vec3d d, const std::vector<Turn>& turns);

/// Angle between two directions [deg].
double angle_between(Vec3d a, Vec3d b);

/// Where f, which falls and then rises between lo and hi, is least (golden section).
template <class F>
double least_at(F&& f, double lo, double hi) {
    constexpr double golden = 0.6180339887498949;
    double a = hi - golden * (hi - lo), b = lo + golden * (hi - lo), fa = f(a), fb = f(b);
    for (int i = 0; i < 60; ++i)
        if (fa < fb) {
            hi = b, b = a, fb = fa;
            a = hi - golden * (hi - lo), fa = f(a);
        } else {
            lo = a, a = b, fa = fb;
            b = lo + golden * (hi - lo), fb = f(b);
        }
    return (lo + hi) / 2;
}

/// Where `below` ends to be true between lo and hi.
template <class F>
double border(F&& below, double lo, double hi) {
    for (int i = 0; i < 40; ++i) (below((lo + hi) / 2) ? lo : hi) = (lo + hi) / 2;
    return (lo + hi) / 2;
}

}  // namespace cardioid::test
