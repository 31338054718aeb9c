#pragma once
#include <cmath>

#include "photon/map/hull.hpp"
#include "photon/map/tree/kd_tree.hpp"

namespace cardioid::photon {

/// The correction of ARL-TR-3608, note [8]: of all points within sqrt(r2) of the query, the share that passed its
/// tests, `accepted` of them. Wrong where densities differ and at free edges; for `mode = report`.
[[nodiscard]] float accepted_share(const KdTree& tree, PointQuery query, float r2, std::uint32_t accepted) noexcept;

/// The correction by the hull: photons that are no corners of the hull weigh 1 / its area each, corners nothing, which
/// has no bias on a convex piece of surface (Efron 1965: the expected share of the area is that of the points that are
/// not corners). Only where the hull leaves out a tenth of the disc and has the query, (0, 0), within it or no farther
/// out than hulls fall short of their domains, O(k^-2/3) of its size (Renyi, Sulanke 1963); so an edge of shadow is
/// not carried on. Else nothing is done and false returned. `at(i)` is the place of candidate i relative to the query;
/// the farthest is the last. O(k log k).
template <class At>
bool weigh_by_hull(const Frame& plane, float disc_area, const At& at, Neighbours& found) noexcept {
    constexpr std::uint32_t most = 1024;  // more photons know their disc well enough
    if (found.size < 4 || found.size > most) return false;
    PlanePoint points[most], corners[most + 1];
    for (std::uint32_t i = 0; i < found.size; ++i) {
        const Vec3 d = at(i);
        points[i] = {dot(d, plane.s), dot(d, plane.t), i};
    }
    const Hull hull = convex_hull({points, found.size}, {corners, found.size + 1});
    if (!(hull.area > 0 && hull.area < 0.9F * disc_area)) return false;
    const float size = std::cbrt(static_cast<float>(found.size));
    if (hull.outside({}) > 1.4F * std::sqrt(disc_area * inv_pi) / (size * size)) return false;
    std::fill_n(found.d2, found.size, 1 / hull.area);
    for (const PlanePoint& corner : hull.corners) found.d2[corner.index] = 0;
    return true;
}

}  // namespace cardioid::photon
