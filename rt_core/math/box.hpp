#pragma once
#include <limits>

#include "rt_core/math/vec.hpp"

namespace cardioid {

/// An axis-parallel box; empty while lo > hi, unbounded where a side is infinite.
struct Box3d {
    static constexpr double infinity = std::numeric_limits<double>::infinity();
    Vec3d lo{infinity, infinity, infinity};
    Vec3d hi{-infinity, -infinity, -infinity};

    static Box3d everything() { return {{-infinity, -infinity, -infinity}, {infinity, infinity, infinity}}; }
    [[nodiscard]] bool empty() const { return !(lo.x <= hi.x && lo.y <= hi.y && lo.z <= hi.z); }
    [[nodiscard]] bool bounded() const { return is_finite(lo) && is_finite(hi); }
    void include(Vec3d p) { lo = min(lo, p), hi = max(hi, p); }
    void include(const Box3d& b) { lo = min(lo, b.lo), hi = max(hi, b.hi); }
    [[nodiscard]] Box3d intersection(const Box3d& b) const { return {max(lo, b.lo), min(hi, b.hi)}; }
    [[nodiscard]] bool overlaps(const Box3d& b) const { return !intersection(b).empty(); }
    [[nodiscard]] bool contains(Vec3d p) const {
        return p.x >= lo.x && p.x <= hi.x && p.y >= lo.y && p.y <= hi.y && p.z >= lo.z && p.z <= hi.z;
    }
    [[nodiscard]] Vec3d centre() const { return (lo + hi) * 0.5; }
    [[nodiscard]] Vec3d size() const { return hi - lo; }
    /// Length of the space diagonal; 0 for an empty box.
    [[nodiscard]] double diagonal() const { return empty() ? 0 : length(size()); }
    [[nodiscard]] Box3d padded(double by) const { return {lo - Vec3d{by, by, by}, hi + Vec3d{by, by, by}}; }
};

}  // namespace cardioid
