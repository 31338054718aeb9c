#include "photon/gather/final_gather.hpp"

namespace cardioid::photon {

namespace {

/// Where irradiance would change by all of itself within less than what is seen around, that is how far a point knows.
float limited_distance(const HemisphereReading& reading) {
    const Gradient& g = reading.translational;
    const float slope = length(g.r * 0.2126F + g.g * 0.7152F + g.b * 0.0722F);
    const float E = luminance(reading.E);
    return slope * reading.harmonic_distance > E ? E / slope : reading.harmonic_distance;
}

}  // namespace

CacheRecord FinalGather::record(const SurfacePoint& point, Vec3 n, std::uint64_t index, Vec3d origin) const {
    const Frame frame(n);
    std::vector<HemisphereRay> rays(static_cast<std::size_t>(hemisphere_.size()));
    const Vec3 ng = dot(point.ng, n) < 0 ? -point.ng : point.ng;
    BsdfMemory memory;
    const Bsdf& bsdf = *world_.bsdf(point, memory);
    for (int j = 0, i = 0; j < hemisphere_.rings; ++j)
        for (int k = 0; k < hemisphere_.sectors; ++k, ++i) {
            Sampler sampler(seed_, Purpose::cache, index, static_cast<std::uint32_t>(i));
            HemisphereRay& ray = rays[static_cast<std::size_t>(i)];
            ray.d = hemisphere_.direction(j, k, sampler.next2());
            ray.distance = std::numeric_limits<float>::infinity();
            const Vec3 wi = frame.to_world(ray.d);
            if (!(dot(wi, ng) > 0)) continue;
            const IncomingLight::Found found = light_.along(point, wi, sampler);
            ray.distance = static_cast<float>(found.distance);
            const Rgb taken = found.L * bsdf.diffuse_acceptance(point.frame.to_local(wi));
            if (is_finite(taken)) ray.L = taken;
        }
    const HemisphereReading reading = read_hemisphere(hemisphere_, frame, rays);
    CacheRecord record;
    record.p = Vec3(point.p - origin);
    record.n = n;
    record.E = reading.E;
    record.rotational = reading.rotational;
    record.translational = reading.translational;
    record.distance = limited_distance(reading);
    record.occluders = Occluders(hemisphere_, rays, reading.harmonic_distance);
    return record;
}

}  // namespace cardioid::photon
