#pragma once
#include "photon/cache/cache_record.hpp"

namespace cardioid::photon {

/// Three channels, and one that is not used, in a register.
using Channels = float __attribute__((vector_size(16)));
inline Channels channels(Rgb c) noexcept { return Channels{c.r, c.g, c.b, 0}; }

/// What of a cache record every lookup reads: where it is and CacheRecord::guess, its derivatives by column.
struct CacheGuess {
    explicit CacheGuess(const CacheRecord& r) noexcept
        : E(channels(r.E)), rotational{}, translational{}, p(r.p), n(r.n) {
        for (int axis = 0; axis < 3; ++axis) {
            const Gradient &turn = r.rotational, &step = r.translational;
            rotational[axis] = channels({turn.r[axis], turn.g[axis], turn.b[axis]});
            translational[axis] = channels({step.r[axis], step.g[axis], step.b[axis]});
        }
        const float nearest = r.occluders.nearest();
        free2 = nearest * nearest;
    }
    /// CacheRecord::guess.
    [[nodiscard]] Channels at(Vec3 step, Vec3 normal) const noexcept {
        const Vec3 axis = cross(n, normal);
        const Channels sum = E + (rotational[0] * axis.x + rotational[1] * axis.y + rotational[2] * axis.z) +
                             (translational[0] * step.x + translational[1] * step.y + translational[2] * step.z);
        return sum > 0 ? sum : Channels{};
    }

    Channels E, rotational[3], translational[3];
    Vec3 p, n;
    float free2;  ///< squared distance up to which nothing stands in the way
};

/// The weighted mean of guesses.
class GuessSum {
public:
    void add(const CacheGuess& guess, Vec3 step, Vec3 normal, float weight) noexcept {
        sum_ += guess.at(step, normal) * weight;
        weights_ += weight;
    }
    [[nodiscard]] float weights() const noexcept { return weights_; }
    [[nodiscard]] Rgb mean() const noexcept {
        const Channels mean = sum_ * (1 / weights_);
        return {mean[0], mean[1], mean[2]};
    }

private:
    Channels sum_{};
    float weights_ = 0;
};

}  // namespace cardioid::photon
