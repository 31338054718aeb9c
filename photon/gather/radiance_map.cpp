#include "photon/gather/radiance_map.hpp"

#include <algorithm>

#include "photon/map/edges.hpp"

namespace cardioid::photon {

namespace {

/// The report lets normals differ by 60 degrees.
constexpr float report_least_cos = 0.5F;

std::unordered_map<std::uint32_t, float> farthest_reach(const std::vector<RadiancePhoton>& photons) {
    std::unordered_map<std::uint32_t, float> out;
    for (const RadiancePhoton& photon : photons) {
        float& reach = out[photon.region];
        reach = std::max(reach, photon.reach);
    }
    return out;
}

}  // namespace

RadianceMap::RadianceMap(const std::vector<RadiancePhoton>& photons, Vec3d origin)
    : tree_(photons), origin_(origin), reach_(farthest_reach(photons)) {}

const RadiancePayload* RadianceMap::nearest(const SurfacePoint& point, Vec3 ng) const noexcept {
    const auto reach = reach_.find(point.id.region);
    if (reach == reach_.end()) return nullptr;
    PointQuery query = same_surface(Vec3(point.p - origin_), ng, point.id.region);
    query.max_radius = reach->second;  // else a search for what is not there goes through the whole tree
    const Nearest found = tree_.nearest(query);
    if (!found.found()) return nullptr;
    const RadiancePayload& known = tree_.payload(found.index);
    return found.d2 <= known.reach * known.reach ? &known : nullptr;
}

Rgb RadianceMap::mean(const SurfacePoint& point, Vec3 ng, std::uint32_t nearest, bool edges) const noexcept {
    const PointQuery query{.p = Vec3(point.p - origin_), .n = ng, .least_cos = report_least_cos};
    Neighbours found;
    tree_.nearest(query, nearest, found);
    if (found.size == 0) return {};
    Rgb sum;
    for (std::uint32_t i = 0; i < found.size; ++i) {
        const RadiancePayload& known = tree_.payload(found.index[i]);
        if (found.d2[i] <= known.reach * known.reach) sum += known.E;
    }
    const float share = edges ? accepted_share(tree_, query, found.d2[found.size - 1], found.size) : 1;
    return sum * (1 / (static_cast<float>(found.size) * share));
}

bool RadianceMap::near(Vec3d p, float radius) const noexcept {
    return tree_.nearest({.p = Vec3(p - origin_), .max_radius = radius}).found();
}

std::vector<RadiancePhoton> RadianceMap::photons() const {
    std::vector<RadiancePhoton> all(size());
    for (std::uint32_t i = 0; i < size(); ++i) {
        const RadiancePayload& known = tree_.payload(i);
        all[i] = {tree_.position(i), tree_.normal(i), tree_.region(i), known.E, known.blur, known.reach};
    }
    return all;
}

}  // namespace cardioid::photon
