#include "photon/map/edges.hpp"

#include <cmath>

namespace cardioid::photon {

float accepted_share(const KdTree& tree, PointQuery query, float r2, std::uint32_t accepted) noexcept {
    query.max_radius = std::sqrt(r2);
    query.least_cos = -1;
    query.steepness = std::numeric_limits<float>::infinity();
    query.region = FaceId::none;
    std::uint32_t all = 0;
    tree.visit_within(query, [&](std::uint32_t, float) { ++all; });
    return all > accepted ? static_cast<float>(accepted) / static_cast<float>(all) : 1;
}

}  // namespace cardioid::photon
