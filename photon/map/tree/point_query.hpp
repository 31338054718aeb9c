#pragma once
#include <cstdint>
#include <limits>

#include "rt_core/api/surface.hpp"

namespace cardioid::photon {

/// A surface that bends like a circle rises over its plane by half the sine of the angle between the normals, for a
/// unit of distance. A point that rises more than four times that is on another surface: what lies deeper or higher
/// with the same normal, as the bottom of a groove or letters that stand out. Squares, for a squared sine of 1, and
/// what the rounding of normals may add to one of 0.
inline constexpr float most_bend2 = 4, bend_slack2 = 4e-8F;

/// Which points a query wants. Where both heights and normals are tested, the two have to agree (most_bend2).
/// Everything is relative to the tree's own origin; distances are Euclidean but for `flatten`.
struct PointQuery {
    Vec3 p;                                                     ///< finite
    float max_radius = std::numeric_limits<float>::infinity();  ///< > 0; a point at exactly this distance counts
    Vec3 n{0, 0, 1};                                            ///< unit; what the tests below are about
    float least_cos = -1;                                       ///< of the angle of normals, in [0, 1]; below 0: any
    float steepness = std::numeric_limits<float>::infinity();   ///< height over the plane a unit of distance in it
    float slack = 0;                                            ///< height that is always allowed, scene units
    float flatten = 1;                                          ///< heights count this many times in distances; >= 1
    std::uint32_t region = FaceId::none;                        ///< the only one wanted; none: any
};

/// What a query found: `size` points, the farthest of them the last, the others in no order (the same at every call).
/// Big (160 KB), to be left uninitialised on a stack; only what is used is touched.
struct Neighbours {
    static constexpr std::uint32_t max_k = 10000;          ///< the most that KdTree::nearest may be asked for
    static constexpr std::uint32_t room = 2 * max_k + 64;  ///< candidates, and what a vector may write past them
    std::uint32_t size;
    alignas(64) float d2[room];             ///< squared distances
    alignas(64) std::uint32_t index[room];  ///< of the points in the tree
    Neighbours() noexcept : size(0) {}      // NOLINT: the rest is written before it is read
};

/// One point, or none.
struct Nearest {
    static constexpr std::uint32_t none = 0xFFFFFFFFU;
    std::uint32_t index = none;
    float d2 = std::numeric_limits<float>::infinity();
    [[nodiscard]] bool found() const { return index != none; }
};

}  // namespace cardioid::photon
