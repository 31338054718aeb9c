#pragma once
#include <vector>

#include "rt_core/api/eye.hpp"

namespace cardioid::photon {

/// A place that the picture shows.
struct Sighting {
    SurfacePoint point;
    Vec3 n;  ///< geometric normal on the side that is seen
};

/// Places seen through a grid of film points over the drawn part of the picture; few where mostly nothing is seen.
[[nodiscard]] std::vector<Sighting> look_around(const Eye& eye, std::uint32_t seed);

/// Length that is one picture wide at the places seen (their median) [scene units]; 0 where nothing is seen.
[[nodiscard]] double picture_width(const std::vector<Sighting>& sights, const Eye& eye);

}  // namespace cardioid::photon
