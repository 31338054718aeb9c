#include "photon/propagation/photon_path.hpp"

#include "photon/propagation/breadth.hpp"

namespace cardioid::photon {

namespace {

/// A path this long is cut off: a photon between perfect mirrors would never end.
constexpr int most_bounces = 10'000;

Way way_of(Lobe lobe) {
    if (any(lobe & Lobe::diffuse)) return Way::diffuse;
    return any(lobe & Lobe::glossy) ? Way::glossy : Way::specular;
}

}  // namespace

/// A photon on its way.
struct PhotonPath::Leg {
    Ray ray;
    Rgb flux;
    const Light& light;
    bool has_face;  ///< it left a face of its lamp
    Way way = Way::direct;
    FirstMirror first;
    Breadth lobe = Breadth::none;  ///< of the glossy surface that it met last
    double length = 0;             ///< of its way from the lamp
    int bounces = 0;
    bool caustic = false;  ///< has left a caustic photon
};

void PhotonPath::follow(const Light& light, Ray ray, Rgb flux, Sampler& sampler) {
    ++ledger.paths;
    if (!is_finite(flux)) {
        ++ledger.not_finite;
        return;
    }
    if (!(max_component(flux) > 0)) return;
    ledger.emitted += flux;
    Leg leg{ray, flux, light, ray.from.region != FaceId::none};
    while (step(leg, sampler)) {
        if (++leg.bounces < most_bounces) continue;
        ++ledger.cut;
        ledger.cut_off += leg.flux;
        break;
    }
    if (leg.caustic) ++ledger.caustic_paths;
}

/// One segment and the surface at its end; false where the path ends, its flux accounted for.
bool PhotonPath::step(Leg& leg, Sampler& sampler) {
    ++ledger.rays;
    const Hit hit = world_.intersect(leg.ray);
    if (!hit.found()) {
        ledger.escaped += leg.flux;
        return false;
    }
    leg.length += hit.t;
    const SurfacePoint point = world_.surface(leg.ray, hit);
    const Vec3 wo(-leg.ray.d);
    // The side it arrives on tells what it came through, without a record of what it entered and left.
    const Medium* medium = dot(point.ng, wo) > 0 ? point.front : point.back;
    if (medium && !is_black(medium->absorption)) {
        const Rgb left = pass_medium(*medium, hit.t, leg.flux, sampler.next());
        ledger.absorbed += leg.flux;
        ledger.absorbed -= left;
        leg.flux = left;
        if (is_black(left)) return false;
    }
    if (point.lamp >= 0) {
        ledger.absorbed += leg.flux;
        return false;
    }
    BsdfMemory memory;
    return bounce(leg, point, *world_.bsdf(point, memory), sampler);
}

/// Keeps the photon and sends it on; false where it is absorbed.
bool PhotonPath::bounce(Leg& leg, const SurfacePoint& point, const Bsdf& bsdf, Sampler& sampler) {
    const Lobe lobes = bsdf.lobes();
    const bool scatters = any(lobes & (Lobe::diffuse | Lobe::glossy));
    if (leg.bounces == 0 && any(lobes & (Lobe::specular | Lobe::glossy))) ++ledger.specular_first;
    // Where there is nothing to choose, the roulette's number is enough.
    const Vec2 u = lobes == Lobe::diffuse ? Vec2{0, sampler.next()} : sampler.next2();
    const Vec2 u_direction = sampler.next2();
    const Vec3 wo = point.frame.to_local(Vec3(-leg.ray.d));
    const Lobe which = store_.keep == Keep::caustics ? Lobe::glossy | Lobe::specular | Lobe::transmitted : Lobe::all;
    Scattered next = scatter({world_, point, bsdf, wo, leg.flux, which, rule_}, u, u_direction);
    if (!is_finite(next.flux)) {
        ++ledger.not_finite;
        ledger.cut_off += leg.flux;
        return false;
    }
    const bool ends = is_black(next.flux);
    if (scatters && (ends || store_.which == Store::all)) keep(leg, point);
    ledger.absorbed += leg.flux;
    if (ends) return false;
    ledger.absorbed -= next.flux;
    leg.flux = next.flux;
    if (!next.straight) turn(leg, point, bsdf, next);
    if (store_.keep == Keep::caustics && path_class(leg.way) == PathClass::indirect) {
        ledger.absorbed += leg.flux;
        return false;
    }
    // A filter does not bend the ray at all: rounding must not either.
    const Vec3d unbent = leg.ray.d;
    leg.ray = point.ray(point.frame.to_world(next.wi));
    if (next.straight) leg.ray.d = unbent;
    return true;
}

/// Notes what bends its way.
void PhotonPath::turn(Leg& leg, const SurfacePoint& point, const Bsdf& bsdf, const Scattered& next) const {
    const Way how = way_of(next.lobe);
    if (leg.way == Way::direct) leg.first = {point.p, Vec3(-leg.ray.d), leg.length};
    leg.way = leg.way | how;
    if (how != Way::glossy) return;
    leg.lobe = lobe_breadth(bsdf, next.wi, store_.least_breadth);
    if (store_.broad_apart && is_broad(bsdf, next.wi)) leg.way = leg.way | Way::broad;
}

/// Of light that came by mirrors, glass and glossy lobes.
Breadth PhotonPath::breadth(const Leg& leg) {
    if (has(leg.way, Way::glossy)) return leg.lobe;
    return photon_breadth(leg.light, leg.has_face, leg.first, leg.length);
}

void PhotonPath::keep(Leg& leg, const SurfacePoint& point) {
    const PathClass kind = path_class(leg.way);
    leg.caustic = leg.caustic || kind == PathClass::caustic;
    if (store_.keep == Keep::caustics && kind != PathClass::caustic) return;
    const auto i = static_cast<std::size_t>(kind);
    ++ledger.photons[i];
    ledger.stored[i] += leg.flux;
    if (store_.unwanted[i]) return;
    const Vec3 wi(-leg.ray.d);
    const Vec3 n = dot(point.ng, wi) < 0 ? -point.ng : point.ng;
    const Vec3 p(point.p - store_.origin);
    photons.push_back({p, encode_flux(leg.flux, store_.scale, flux_dither(p)), encode_direction(wi),
                       encode_direction(n), point.id.region, leg.way,
                       kind == PathClass::caustic ? breadth(leg) : Breadth::none, 0});
}

}  // namespace cardioid::photon
