#include "photon/map/photon_map.hpp"

#include <algorithm>
#include <cmath>

#include "photon/map/edges.hpp"
#include "photon/map/kernel.hpp"
#include "photon/map/probe_area.hpp"
#include "photon/map/spread.hpp"

namespace cardioid::photon {

namespace {

/// Positions are floats about the origin of their map: heights of this share of a place's distance may be rounding.
constexpr float rounding = 0x1p-22F;

/// How far half of the photons are from the origin, along one axis. Not how far all are: on a floor without end one
/// photon in a million lands where its rounding is larger than the model.
float usual_distance(const PointTree<Photon>& tree) {
    constexpr std::uint32_t enough = 4096;
    std::vector<float> distances;
    const std::uint32_t step = std::max(tree.size() / enough, 1U);
    for (std::uint32_t i = 0; i < tree.size(); i += step) distances.push_back(max_component(abs(tree.position(i))));
    if (distances.empty()) return 0;
    const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
    std::nth_element(distances.begin(), middle, distances.end());
    return *middle;
}

}  // namespace

PhotonMap::PhotonMap(std::span<const Photon> photons, Vec3d origin, float flux_scale)
    : tree_(photons), origin_(origin), flux_scale_(flux_scale), distance_(usual_distance(tree_)) {}

float PhotonMap::slack(Vec3 p) const noexcept { return rounding * std::max(distance_, max_component(abs(p))); }

void PhotonMap::spread(const LookupRule& rule) { reach_ = spread_photons(*this, rule); }

PointQuery PhotonMap::query(Vec3 p, Vec3 n, std::uint32_t region, const LookupRule& rule) const noexcept {
    return {.p = p,
            .max_radius = rule.max_radius,
            .n = n,
            .least_cos = rule.least_cos,
            .steepness = rule.steepness,
            .slack = slack(p),
            .flatten = rule.flatten,
            .region = rule.same_region ? region : FaceId::none};
}

void PhotonMap::weigh(const SurfacePoint& point, Vec3 n, const LookupRule& rule, const World* world,
                      WeighedPhotons& out) const noexcept {
    if (rule.spread && !reach_.empty()) return weigh_spread(point, n, rule, world, out);
    const PointQuery q = query(Vec3(point.p - origin_), n, point.id.region, rule);
    Neighbours& found = out.found;
    const std::uint32_t wanted = rule.fixed_radius ? Neighbours::max_k : rule.k;
    tree_.nearest(q, wanted, found);
    const bool last_sets_radius = found.size == wanted || std::isinf(rule.max_radius);
    out.k = found.size;
    out.radius = rule.max_radius;
    if (found.size == 0) return;
    // Places are known to `slack` only: photons all at one place light a disc of that radius.
    const float least2 = std::max(q.slack * q.slack, std::numeric_limits<float>::min());
    const float r2 = std::max(last_sets_radius ? found.d2[found.size - 1] : rule.max_radius * rule.max_radius, least2);
    out.radius = std::sqrt(r2);
    const EdgeRule edge = rule.edge == EdgeRule::probe && !world ? EdgeRule::hull : rule.edge;
    const auto photon_at = [&](std::uint32_t i) { return tree_.position(found.index[i]) - q.p; };
    if (edge == EdgeRule::hull && weigh_by_hull(Frame(n), pi * r2, photon_at, found)) return;
    if (last_sets_radius && !rule.count_last) --found.size;
    float share = 1;
    if (edge == EdgeRule::report) share = accepted_share(tree_, q, r2, out.k);
    if (edge == EdgeRule::probe) share = reached_share(*world, point, n, rule, out);
    if (!(share > 0)) found.size = 0;
    for (std::uint32_t i = 0; i < found.size; ++i)
        found.d2[i] = kernel_weight(rule.kernel, std::min(found.d2[i] / r2, 1.0F)) / (pi * r2 * share);
}

/// The disc of the lookup, for probes and for how far its result holds, is as large as those of its photons: their
/// harmonic mean.
void PhotonMap::weigh_spread(const SurfacePoint& point, Vec3 n, const LookupRule& rule, const World* world,
                             WeighedPhotons& out) const noexcept {
    const PointQuery q = query(Vec3(point.p - origin_), n, point.id.region, rule);
    Neighbours& found = out.found;
    found.size = 0;
    float sum = 0, over_radius = 0;
    tree_.visit_reaching(q, reach_, [&](std::uint32_t index, float d2, float r2) {
        if (found.size == Neighbours::room) return;
        const float weight = kernel_weight(rule.kernel, d2 / r2) / (pi * r2);
        found.index[found.size] = index;
        found.d2[found.size++] = weight;
        sum += weight;
        over_radius += weight / std::sqrt(r2);
    });
    out.k = found.size;
    out.radius = over_radius > 0 ? sum / over_radius : rule.max_radius;
    if (found.size == 0) {
        const Nearest photon = tree_.nearest(q);
        if (photon.found()) out.radius = std::sqrt(photon.d2) * 0.6F;
    }
    if (found.size == 0 || !world || (rule.edge != EdgeRule::probe && rule.edge != EdgeRule::hull)) return;
    const float share = reached_share(*world, point, n, rule, out);
    if (!(share > 0)) found.size = 0;
    for (std::uint32_t i = 0; i < found.size; ++i) found.d2[i] /= share;
}

float PhotonMap::reached_share(const World& world, const SurfacePoint& point, Vec3 n, const LookupRule& rule,
                               WeighedPhotons& photons) const noexcept {
    Neighbours& found = photons.found;
    if (found.size == 0) return 1;
    const ProbeDisc disc{.point = point,
                         .n = n,
                         .radius = photons.radius,
                         .least_cos = rule.least_cos,
                         .steepness = rule.steepness,
                         .slack = slack(Vec3(point.p - origin_)),
                         .same_region = rule.same_region,
                         .turn = found.index[0]};
    SurfaceProbe probe(world, disc);
    if (probe.rim_reached()) return 1;
    const float share = probe.reached_share([&](float t2) { return kernel_weight(rule.kernel, t2); });
    if (!probe.something_hides()) return share;
    std::uint32_t seen = 0;
    for (std::uint32_t i = 0; i < found.size; ++i) {
        if (!probe.sees(position(found.index[i]))) continue;
        found.index[seen] = found.index[i];
        found.d2[seen++] = found.d2[i];
    }
    found.size = seen;
    return share;
}

Estimate PhotonMap::irradiance(const SurfacePoint& point, Vec3 n, const LookupRule& rule, const World* world,
                               const Bsdf* taker) const noexcept {
    WeighedPhotons photons;
    weigh(point, n, rule, world, photons);
    Estimate e{.radius = photons.radius, .k = photons.k};
    for (std::uint32_t i = 0; i < photons.found.size; ++i) {
        const std::uint32_t p = photons.found.index[i];
        Rgb share = flux(p) * photons.weight(i);
        if (taker) share *= taker->diffuse_acceptance(point.frame.to_local(direction(p)));
        e.E += share;
        e.variance += share * share;
    }
    return e;
}

std::vector<Photon> PhotonMap::photons() const {
    std::vector<Photon> all(size());
    for (std::uint32_t i = 0; i < size(); ++i) {
        const PhotonPayload& light = tree_.payload(i);
        all[i] = {tree_.position(i), light.flux, light.wi,      tree_.normal(i),
                  tree_.region(i),   light.way,  light.breadth, light.time};
    }
    return all;
}

}  // namespace cardioid::photon
