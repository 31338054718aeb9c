#pragma once
#include <limits>
#include <span>
#include <vector>

#include "photon/hemisphere/hemisphere.hpp"

namespace cardioid::photon {

/// How far one can go from a point along its surface before something stands in the way. A cache point says nothing
/// about places behind that: without this, light leaks under thin walls (ARL-TR-3608, note [11]; that a cache point
/// must know what stands around it is Ward's idea, in Radiance's ambient cache).
class Occluders {
public:
    /// Nothing stands anywhere.
    Occluders() noexcept = default;
    /// What the lowest ring of a hemisphere has met, as the corners of a polygon. Nothing farther than `reach` counts.
    Occluders(const Hemisphere& hemisphere, std::span<const HemisphereRay> rays, float reach);

    /// Whether the way along v, a vector in the frame of the hemisphere, is free to its end.
    [[nodiscard]] bool free(Vec3 v) const noexcept { return v.x * v.x + v.y * v.y <= nearest_ * nearest_ || inside(v); }
    /// Up to here every way is free, scene units.
    [[nodiscard]] float nearest() const noexcept { return nearest_; }

private:
    [[nodiscard]] bool inside(Vec3 v) const noexcept;

    std::vector<Vec2> corners_;  ///< one in each sector
    float nearest_ = std::numeric_limits<float>::infinity();
};

}  // namespace cardioid::photon
