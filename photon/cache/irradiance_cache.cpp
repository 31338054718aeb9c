#include "photon/cache/irradiance_cache.hpp"

#include <algorithm>

namespace cardioid::photon {

namespace {

/// Up to here a point reaches comfortably. The rest of its reach is for places that the eye finds later, between those
/// that the cache was made for.
constexpr float comfort = 0.8F;

/// How much a point counts whose error is t of what is allowed. Ward's 1/t shows each point's own noise as a blot
/// around it; with gradients a point errs as t^2 alone, so that points count nearly alike and average their noise.
float weight(float t) { return 1 - t; }

}  // namespace

IrradianceCache::IrradianceCache(const CacheRules& rules, const Box3d& bounds)
    : rules_(rules),
      origin_(bounds.centre()),
      neighbours_(Vec3(bounds.lo - bounds.centre()),
                  static_cast<float>(std::max(max_component(bounds.size()), 1e-30))) {}

void IrradianceCache::tame_gradient(CacheRecord& record) const {
    const float known = rules_.reach * record.distance;
    if (!(known < record.least)) return;
    const float share = known / record.least;
    record.translational.r *= share;
    record.translational.g *= share;
    record.translational.b *= share;
}

void IrradianceCache::clamp_neighbours(CacheRecord& record) {
    const float radius = reach(record);
    const auto related = [&](const CacheRecord& other) { return dot(record.n, other.n) > 0; };
    neighbours_.overlapping(record.p, radius, [&](std::uint32_t i) {
        const CacheRecord& other = records_[i];
        if (related(other)) record.distance = std::min(record.distance, other.distance + length(record.p - other.p));
    });
    neighbours_.overlapping(record.p, radius, [&](std::uint32_t i) {
        CacheRecord& other = records_[i];
        if (related(other)) other.distance = std::min(other.distance, record.distance + length(record.p - other.p));
    });
}

void IrradianceCache::add(std::vector<CacheRecord> records) {
    for (CacheRecord& record : records) {
        tame_gradient(record);
        const float own = reach(record);
        clamp_neighbours(record);
        neighbours_.add(record.p, own);
        guesses_.emplace_back(record);
        records_.push_back(std::move(record));
    }
    std::vector<Reach> reaches;
    reaches.reserve(records_.size());
    for (const CacheRecord& record : records_) reaches.push_back({record.p, record.n, reach(record)});
    index_.rebuild(reaches);
}

std::optional<Rgb> IrradianceCache::irradiance(Vec3d p, Vec3 n) const noexcept {
    GuessSum sum;
    around(p, n, [&](std::uint32_t i, Vec3 step, float t) { sum.add(guesses_[i], step, n, weight(t)); });
    if (!(sum.weights() > 0)) return std::nullopt;
    return sum.mean();
}

bool IrradianceCache::lacks(Vec3d p, Vec3 n) const noexcept {
    bool found = false;
    around(p, n, [&](std::uint32_t, Vec3, float t) { found = found || t < comfort; });
    return !found;
}

}  // namespace cardioid::photon
