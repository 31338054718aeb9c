#pragma once
#include <algorithm>
#include <cmath>

#include "csg/leaves/leaf.hpp"
#include "rt_core/api/surface.hpp"

namespace cardioid::csg {

/// How close two crossings count as one. All are lengths in scene units, relative to the size of the scene.
struct Tolerances {
    double exact = 0;  ///< distances along a ray closer than this differ by rounding alone
    double weld = 0;   ///< parallel faces closer than this, along their normal, are one; 0: only exact ties are
    double start = 0;  ///< the same for faces through the origin of a ray that leaves a surface
};

/// A grazing ray spreads the distance between parallel faces; beyond this factor they are not looked for.
inline constexpr double most_spread = 1e3;

/// Rounding of distances along this ray.
inline double exact_along(const Tolerances& tolerances, const Ray& ray) {
    return tolerances.exact + 1e-12 * max_component(abs(ray.o));
}

/// Whether two unit normals are parallel, within 1e-4.
inline bool parallel(const Vec3d& a, const Vec3d& b) {
    const Vec3d c = cross(a, b);
    return dot(c, c) <= 1e-8;
}

/// Whether an event is on the very surface the ray leaves: at its origin, or on a parallel face within `start` of it.
inline bool starts_here(const Ray& ray, const Tolerances& tolerances, double exact, const SolvedLeaf& leaf,
                        const Event& event) {
    if (ray.from.region == FaceId::none) return false;
    const double distance = std::abs(event.t);
    if (distance <= exact) return true;
    if (distance > most_spread * tolerances.start) return false;
    const Vec3d n = normal(leaf, event.face, ray.o + ray.d * event.t), from(ray.from_ng);
    return distance * std::min(std::abs(dot(n, ray.d)), std::abs(dot(from, ray.d))) <= tolerances.start &&
           parallel(n, from);
}

}  // namespace cardioid::csg
