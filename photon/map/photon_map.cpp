#include "photon/map/photon_map.hpp"

#include <array>
#include <cmath>

#include "photon/map/edges.hpp"
#include "photon/map/even_disc.hpp"
#include "photon/map/kernel.hpp"
#include "photon/map/probe_area.hpp"

namespace cardioid::photon {

namespace {

/// Positions are floats about the origin of their map: heights of this share of its extent may be rounding.
constexpr float rounding = 0x1p-22F;
/// The smallest disc of a lookup that adapts, in photons: a standard error of 18 %.
constexpr std::uint32_t least_even = 32;

}  // namespace

PhotonMap::PhotonMap(std::vector<Photon> photons, Vec3d origin, float flux_scale)
    : tree_(std::move(photons)), origin_(origin), flux_scale_(flux_scale) {
    slack_ = rounding * std::max(max_component(abs(tree_.lo())), max_component(abs(tree_.hi())));
}

PointQuery PhotonMap::query(const SurfacePoint& point, Vec3 n, const LookupRule& rule) const noexcept {
    return {.p = Vec3(point.p - origin_),
            .max_radius = rule.max_radius,
            .n = n,
            .least_cos = rule.least_cos,
            .steepness = rule.steepness,
            .slack = slack_,
            .flatten = rule.flatten,
            .region = rule.same_region ? point.id.region : FaceId::none};
}

void PhotonMap::weigh(const SurfacePoint& point, Vec3 n, const LookupRule& rule, const World* world,
                      WeighedPhotons& out) const noexcept {
    const PointQuery q = query(point, n, rule);
    Neighbours& found = out.found;
    const std::uint32_t wanted = rule.fixed_radius ? Neighbours::max_k : rule.k;
    tree_.nearest(q, wanted, found);
    bool last_sets_radius = found.size == wanted || std::isinf(rule.max_radius);
    if (rule.adapt && shrink_to_even(q, found)) last_sets_radius = true;
    out.k = found.size;
    out.radius = rule.max_radius;
    if (found.size == 0) return;
    // Places are known to `slack` only: photons all at one place light a disc of that radius.
    const float least2 = std::max(slack_ * slack_, std::numeric_limits<float>::min());
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

bool PhotonMap::shrink_to_even(const PointQuery& q, Neighbours& found) const noexcept {
    const std::uint32_t all = found.size;
    if (all <= least_even) return false;
    std::array<DiscPhoton, Neighbours::max_k> photons;
    const Frame plane(q.n);
    for (std::uint32_t i = 0; i < all; ++i) {
        const Vec3 d = tree_.position(found.index[i]) - q.p;
        photons[i] = {dot(d, plane.s), dot(d, plane.t), found.d2[i], luminance(flux(found.index[i])), found.index[i]};
    }
    found.size = largest_even_disc({photons.data(), all}, least_even);
    for (std::uint32_t i = 0; i < found.size; ++i) {
        found.d2[i] = photons[i].d2;
        found.index[i] = photons[i].index;
    }
    return found.size < all;
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
                         .slack = slack_,
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

Estimate PhotonMap::irradiance(const SurfacePoint& point, Vec3 n, const LookupRule& rule,
                               const World* world) const noexcept {
    WeighedPhotons photons;
    weigh(point, n, rule, world, photons);
    Estimate e{.radius = photons.radius, .k = photons.k};
    for (std::uint32_t i = 0; i < photons.found.size; ++i) {
        const Rgb share = flux(photons.found.index[i]) * photons.weight(i);
        e.E += share;
        e.variance += share * share;
    }
    return e;
}

std::vector<Photon> PhotonMap::photons() const {
    std::vector<Photon> all(size());
    for (std::uint32_t i = 0; i < size(); ++i) {
        const PhotonPayload& light = tree_.payload(i);
        all[i] = {tree_.position(i), light.flux, light.wi, tree_.normal(i), tree_.region(i), light.way, light.time};
    }
    return all;
}

}  // namespace cardioid::photon
