#include "photon/gather/gather_ends.hpp"

#include <algorithm>
#include <cmath>

#include "photon/gather/side.hpp"
#include "rt_core/api/parallel.hpp"

namespace cardioid::photon {

namespace {

/// Mirrors and glass that a ray follows before it is given up.
constexpr int most_bounces = 16;
/// Film points that one thread looks through at a time, and how many there are at most for a place that is wanted.
constexpr std::size_t chunk_size = 256, most_looks = 4;

constexpr Lobe followed = Lobe::glossy | Lobe::specular | Lobe::transmitted;

/// The film as one sequence that covers it evenly however soon it ends (Roberts 2018, R2).
Vec2d film_point(const Eye::Crop& crop, std::uint64_t i) {
    constexpr double a = 0.7548776662466927, b = 0.5698402909980532;
    const auto x = static_cast<double>(i);
    const double u = x * a - std::floor(x * a), v = x * b - std::floor(x * b);
    return {crop.x0 + u * (crop.x1 - crop.x0), crop.y0 + v * (crop.y1 - crop.y0)};
}

class Finder {
public:
    Finder(const World& world, const Eye& eye, std::uint32_t seed, Vec3d origin)
        : world_(world), eye_(eye), seed_(seed), origin_(origin) {}

    /// Of one ray for each place that is seen through a film point.
    void look(std::uint64_t number, std::vector<Photon>& out) const {
        Sampler sampler(seed_, Purpose::gather, number, ends);
        eye_.look(film_point(eye_.crop(), number), sampler, [&](const Eye::Sight& sight) {
            const Lobe lobes = sight.bsdf.lobes();
            if (any(lobes & Lobe::diffuse)) {
                const Frame frame(shading_normal(sight.point, sight.wo));
                follow(sight.point, frame.to_world(sample_cosine_hemisphere(sampler.next2())), sampler, out);
            } else if (any(lobes & Lobe::glossy)) {
                const float u_lobe = sampler.next();
                const Vec3 wo = sight.point.frame.to_local(sight.wo);
                const BsdfSample s = sight.bsdf.sample(wo, u_lobe, sampler.next2(), Lobe::glossy | Lobe::transmitted);
                if (!is_black(s.weight)) follow(sight.point, sight.point.frame.to_world(s.wi), sampler, out);
            }
        });
    }

private:
    /// Keeps these random numbers apart from those of radiance photons.
    static constexpr std::uint32_t ends = 1U << 30;

    void follow(SurfacePoint point, Vec3 wi, Sampler& sampler, std::vector<Photon>& out) const {
        for (int bounce = 0; bounce < most_bounces; ++bounce) {
            const Ray ray = point.ray(wi);
            const Hit hit = world_.intersect(ray);
            if (!hit.found()) return;
            point = world_.surface(ray, hit);
            if (point.lamp >= 0) return;
            BsdfMemory memory;
            const Bsdf* bsdf = world_.bsdf(point, memory);
            const Lobe lobes = bsdf->lobes();
            if (any(lobes & Lobe::diffuse)) out.push_back(place(point, -wi));
            if (!any(lobes & (Lobe::glossy | Lobe::specular))) return;
            const float u_lobe = sampler.next();
            const BsdfSample s = bsdf->sample(point.frame.to_local(-wi), u_lobe, sampler.next2(), followed);
            if (!is_finite(s.weight) || !(sampler.next() < max_component(s.weight))) return;
            wi = point.frame.to_world(s.wi);
        }
    }

    [[nodiscard]] Photon place(const SurfacePoint& point, Vec3 wo) const {
        Photon photon{};
        photon.p = Vec3(point.p - origin_);
        photon.wi = encode_direction(wo);
        photon.n = encode_direction(geometric_normal(point, wo));
        photon.region = point.id.region;
        return photon;
    }

    const World& world_;
    const Eye& eye_;
    std::uint32_t seed_;
    Vec3d origin_;
};

}  // namespace

std::vector<Photon> gather_ends(const World& world, const Eye& eye, std::uint32_t seed, std::size_t count,
                                Vec3d origin) {
    const Finder finder(world, eye, seed, origin);
    std::vector<Photon> all;
    for (std::size_t looked = 0; all.size() < count && looked < most_looks * count;) {
        const std::size_t looks = std::min(count, most_looks * count - looked);
        std::vector<std::vector<Photon>> chunks((looks + chunk_size - 1) / chunk_size);
        parallel_for(static_cast<std::int64_t>(chunks.size()), [&](std::int64_t c) {
            const auto chunk = static_cast<std::size_t>(c);
            for (std::size_t i = chunk * chunk_size; i < std::min((chunk + 1) * chunk_size, looks); ++i)
                finder.look(looked + i, chunks[chunk]);
        });
        for (const auto& chunk : chunks) all.insert(all.end(), chunk.begin(), chunk.end());
        looked += looks;
    }
    if (all.size() > count) all.resize(count);
    return all;
}

}  // namespace cardioid::photon
