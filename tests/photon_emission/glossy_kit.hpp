#pragma once
#include <gtest/gtest.h>

#include "emission_kit.hpp"

#include "photon/gather/glossy_caustics.hpp"
#include "photon/gather/incoming_light.hpp"
#include "tests/render/path_kit.hpp"

namespace cardioid::test {

inline constexpr Vec3d up{0, 0, 1};

/// A plate below z = 0 of the material, the first solid.
inline SceneKit plate(const std::string& kind,
                      std::initializer_list<std::pair<const char*, std::vector<double>>> values) {
    SceneKit kit;
    kit.root(kit.box({-4, -4, -1}, {4, 4, 0}, kit.material("plate", kind, values)));
    return kit;
}

/// A wall beside the plate whose face is y = 1.
inline void add_wall(SceneKit& kit, std::uint32_t material) { kit.root(kit.box({-8, 1, 0.01}, {8, 1.5, 8}, material)); }

/// What a lamp at `p` that shines along -z is turned by to shine along y.
inline Affine towards_wall(Vec3d p) { return {{Vec3d{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}, p}; }

/// Places in z = 0, and where they are looked at from.
struct Look {
    Vec3d towards{0, 2, 1.5};  ///< what a mirror there would show
    double side = 1.5;
    bool behind = false;  ///< what it shows is seen through it
    /// Calls use(point, bsdf, wo, number) for 5 x 5 places, found by rays from above.
    template <class Use>
    void each(const World& world, Use&& use) const {
        for (int i = 0; i < 25; ++i) {
            const Vec3d p{side * (i % 5 - 2) / 5.0, side * (i / 5 - 2) / 5.0, 0};
            const Vec3d there = normalize(towards - p);
            const Vec3d way = behind ? -there : Vec3d{-there.x, -there.y, there.z};
            const SurfacePoint point = seen(world, p + way * 1e-3, way * -1.0);
            BsdfMemory memory;
            use(point, *world.bsdf(point, memory), Vec3(way), static_cast<std::uint32_t>(i));
        }
    }
};

inline photon::LookupRule caustic_rule(float radius = 0.15F) {
    return {
        .k = 60, .spread = true, .max_radius = radius, .kernel = photon::Kernel::cone, .edge = photon::EdgeRule::none};
}
inline photon::LookupRule beyond_rule(float radius = 0.15F) {
    photon::LookupRule rule = caustic_rule(radius);
    rule.k = 20;
    rule.spread = false;
    return rule;
}

/// Radiance (green) that GlossyCaustics finds, and of broad lobes IncomingLight: a number for each of the maps, the
/// mean of all places, and for each place the mean over all maps of its variance from map to map.
struct Found {
    Moments mean{1};
    double variance = 0;          ///< relative, of a place
    double variance_of_maps = 0;  ///< the same of the map alone with the whole Bsdf
};
inline Found find(const CommittedScene& scene, const Look& look, int maps, std::uint64_t photons,
                  std::uint32_t samples = 8) {
    Found found;
    Progress progress;
    const photon::Aim aim = photon::find_aim(scene, {}, 99, 1 << 15, progress);
    std::array<Moments, 25> places, plain;
    for (Moments& m : places) m = Moments(1);
    for (Moments& m : plain) m = Moments(1);
    for (int i = 0; i < maps; ++i) {
        photon::Shot shot = shoot(scene, photons, {}, photon::Keep::caustics, static_cast<std::uint32_t>(i) + 1);
        photon::PhotonMap map(std::move(shot.photons), shot.origin, shot.flux_scale);
        map.spread(caustic_rule());
        const photon::GlossyCaustics light(scene, map, caustic_rule(), beyond_rule());
        const photon::IncomingLight broad(scene, {.caustics = &map, .caustic_lookup = beyond_rule()});
        double sum = 0;
        look.each(scene, [&](const SurfacePoint& point, const Bsdf& bsdf, Vec3 wo, std::uint32_t at) {
            double L = 0;
            for (std::uint32_t s = 0; s < samples; ++s) {
                Sampler sampler(7, Purpose::test, static_cast<std::uint64_t>(i) * 25 + at, s);
                const Rgb narrow = light.radiance(point, bsdf, wo, sampler);
                L += double{narrow.g} / samples;
                L += double{broad.scattered(point, bsdf, wo, Lobe::glossy | Lobe::transmitted, sampler).g} / samples;
            }
            places[at].add(L);
            plain[at].add(
                double{map.radiance(point, point.ng, caustic_rule(),
                                    [&](Vec3 wi) { return bsdf.f(point.frame.to_local(wo), point.frame.to_local(wi)); })
                           .g});
            sum += L / 25;
        });
        found.mean.add(sum);
    }
    const auto add = [&](const std::array<Moments, 25>& all, double& variance) {
        for (const Moments& m : all) variance += m.error() * m.error() * maps / (25 * m.mean() * m.mean());
    };
    add(places, found.variance);
    add(plain, found.variance_of_maps);
    return found;
}

/// What `path` finds in a scene without diffuse surfaces, where what it calls indirect came by glossy ones.
inline Moments by_paths(const CommittedScene& scene, const Look& look, std::uint32_t batches) {
    const PathKit paths(scene);
    Moments mean(1);
    for (std::uint32_t b = 0; b < batches; ++b) {
        double sum = 0;
        look.each(scene, [&](const SurfacePoint& point, const Bsdf& bsdf, Vec3 wo, std::uint32_t at) {
            for (std::uint32_t s = 0; s < batch; ++s) {
                Sampler sampler(3, Purpose::test, std::uint64_t{b} * 25 + at, s);
                const LightingModule& path = paths.module();
                sum += double{path.caustic(scene, point, bsdf, wo, sampler).g};
                sum += double{path.indirect(scene, point, bsdf, wo, sampler).g};
            }
        });
        mean.add(sum / (25 * batch));
    }
    return mean;
}

}  // namespace cardioid::test
