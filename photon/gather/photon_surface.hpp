#pragma once
#include <optional>

#include "photon/map/photon.hpp"
#include "rt_core/api/world.hpp"

namespace cardioid::photon {

/// The surface that the photon fell on; `origin` is what its position is relative to. Nothing where rounding has put it
/// beside an edge.
[[nodiscard]] std::optional<SurfacePoint> surface_under(const World& world, const Photon& photon, Vec3d origin);

}  // namespace cardioid::photon
