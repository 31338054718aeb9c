#pragma once
#include <optional>
#include <vector>

#include "photon/cache/cache_guess.hpp"
#include "photon/cache/cache_index.hpp"
#include "photon/cache/cache_record.hpp"
#include "photon/cache/neighbour_tree.hpp"

namespace cardioid::photon {

/// How far a cache point may be used.
struct CacheRules {
    float reach = 0.15F;                       ///< a of equation 5: its share of the harmonic mean distance
    float turn = 0.2F;                         ///< largest sqrt(1 - n.n_i); 0.2 is 16 degrees
    float least_pixels = 3, most_pixels = 30;  ///< limits of a point's reach, as its place is seen
};

/// Irradiance that changes slowly, kept at few points and guessed between them (Ward, Rubinstein, Clear 1988;
/// ARL-TR-3608, section 5, equations 5 and 6), with gradients (Ward, Heckbert 1992) and reaches that agree with those
/// of their neighbours (Krivanek et al. 2006). Points are added by one thread, in batches; between that any thread may
/// look up. The result depends on the order of the points alone.
class IrradianceCache {
public:
    /// All points will be within `bounds`, not empty.
    IrradianceCache(const CacheRules& rules, const Box3d& bounds);

    /// Adds the points in order; each takes a reach that its neighbours allow, and limits theirs. Their positions are
    /// relative to origin(). Where a reach becomes smaller a place may lose its points: lacks() tells.
    void add(std::vector<CacheRecord> records);

    /// Irradiance at p on the side of n, by equation 5; nothing where no point reaches.
    [[nodiscard]] std::optional<Rgb> irradiance(Vec3d p, Vec3 n) const noexcept;
    /// Whether there should be one more point here: none reaches comfortably.
    [[nodiscard]] bool lacks(Vec3d p, Vec3 n) const noexcept;

    /// Calls visit(i, step, t) for the points that may be used at p on the side of n: records()[i], p relative to it,
    /// and equation 6 as a share of what is allowed, in [0, 1).
    template <class Visit>
    void around(Vec3d p, Vec3 n, Visit&& visit) const noexcept {
        const Vec3 q(p - origin_);
        index_.around(q, n, rules_.turn, [&](std::uint32_t i, float t) {
            const CacheGuess& guess = guesses_[i];
            const Vec3 step = q - guess.p;
            if (dot(step, step) > guess.free2 && !is_free(i, step)) return;
            visit(i, step, t);
        });
    }

    [[nodiscard]] const CacheRules& rules() const noexcept { return rules_; }
    [[nodiscard]] Vec3d origin() const noexcept { return origin_; }
    [[nodiscard]] const std::vector<CacheRecord>& records() const noexcept { return records_; }
    /// How far a record may be used, scene units.
    [[nodiscard]] float reach(const CacheRecord& record) const noexcept {
        return std::clamp(rules_.reach * record.distance, record.least, record.most);
    }
    [[nodiscard]] std::size_t memory_bytes() const noexcept {
        return index_.memory_bytes() + records_.capacity() * sizeof(CacheRecord) +
               guesses_.capacity() * sizeof(CacheGuess);
    }

private:
    /// A record that is used beyond where it knows, for its reach has a lower limit, must not go on with its slope.
    void tame_gradient(CacheRecord& record) const;
    void clamp_neighbours(CacheRecord& record);
    /// Whether nothing stands between the record's place and the one a step away.
    [[nodiscard]] bool is_free(std::uint32_t i, Vec3 step) const noexcept {
        return records_[i].occluders.free(Frame(records_[i].n).to_local(step));
    }

    CacheRules rules_;
    Vec3d origin_;
    std::vector<CacheRecord> records_;
    std::vector<CacheGuess> guesses_;  ///< of each record what every lookup reads
    NeighbourTree neighbours_;
    CacheIndex index_;
};

}  // namespace cardioid::photon
