#include "photon/lighting/shown_place.hpp"

#include <algorithm>

#include "photon/gather/side.hpp"

namespace cardioid::photon {

namespace {

const Rgb ground(0.15F), outside(0.45F), left_out(0.9F, 0.1F, 0.05F), disc(0.1F, 0.15F, 0.35F);

}  // namespace

ShownPlace::ShownPlace(const World& world, const Eye& eye, const PhotonOptions& options, const LightMaps& maps,
                       const Hemisphere& hemisphere, std::uint32_t seed) {
    const Eye::Crop crop = eye.crop();
    const std::array<double, 2> middle{(crop.x0 + crop.x1) / 2.0, (crop.y0 + crop.y1) / 2.0};
    const auto [x, y] = options.view_pixel.value_or(middle);
    Sampler sampler(seed, Purpose::statistics, 0, 0);
    eye.look({x, y}, sampler, [&](const Eye::Sight& sight) {
        if (place_) return;
        place_ = sight.point;
        ng_ = geometric_normal(sight.point, sight.wo);
        n_ = shading_normal(sight.point, sight.wo);
    });
    if (!place_) return;
    if (maps.global) look_up(world, *maps.global, maps.global_lookup);
    shoot_rays(world, hemisphere, seed);
}

void ShownPlace::look_up(const World& world, const PhotonMap& map, const LookupRule& rule) {
    WeighedPhotons photons;
    map.weigh(*place_, ng_, rule, &world, photons);
    radius_ = photons.radius;
    float most = 0;
    for (std::uint32_t i = 0; i < photons.found.size; ++i) most = std::max(most, photons.weight(i));
    for (std::uint32_t i = 0; i < photons.found.size; ++i)
        counted_.emplace_back(photons.found.index[i], most > 0 ? photons.weight(i) / most : 0.0F);
    std::sort(counted_.begin(), counted_.end());
}

void ShownPlace::shoot_rays(const World& world, const Hemisphere& hemisphere, std::uint32_t seed) {
    const Frame frame(n_);
    for (int j = 0, i = 0; j < hemisphere.rings; ++j)
        for (int k = 0; k < hemisphere.sectors; ++k, ++i) {
            Sampler sampler(seed, Purpose::cache, 0, static_cast<std::uint32_t>(i));
            const Ray ray = place_->ray(frame.to_world(hemisphere.direction(j, k, sampler.next2())));
            const Hit hit = world.intersect(ray);
            if (hit.found()) ends_.push_back({ray.o + ray.d * hit.t, j});
        }
}

Rgb ShownPlace::lookup(const PhotonMap* map, const SurfacePoint& point, float dot) const noexcept {
    if (!map || !place_) return ground;
    const Nearest found = map->tree().nearest({.p = Vec3(point.p - map->origin()), .max_radius = dot});
    if (!found.found()) return length(point.p - place_->p) < double{radius_} ? disc : ground;
    const auto at = std::lower_bound(counted_.begin(), counted_.end(), std::pair(found.index, -1.0F));
    if (at != counted_.end() && at->first == found.index) return Rgb(0.3F + 0.7F * at->second);
    return length(map->position(found.index) - place_->p) < double{radius_} ? left_out : outside;
}

Rgb ShownPlace::gather(const SurfacePoint& point, float dot) const noexcept {
    if (!place_) return ground;
    if (length(point.p - place_->p) < double{dot} * 2) return left_out;
    for (const RayEnd& end : ends_)
        if (length(point.p - end.p) < double{dot}) {
            const float t = static_cast<float>(end.ring % 6) / 5;
            return {1, 1 - 0.7F * t, 0.2F + 0.8F * (1 - t)};
        }
    return ground;
}

}  // namespace cardioid::photon
