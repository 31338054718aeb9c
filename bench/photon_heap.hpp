#pragma once
#include <vector>

#include "photon/map/photon.hpp"

namespace cardioid::bench {

/// The photon map as it is commonly built, as a yardstick: a left-balanced kd-tree of whole photons in an array, the
/// nearest kept in a heap (Jensen 2001, chapter 6).
class PhotonHeap {
public:
    explicit PhotonHeap(std::vector<photon::Photon> photons);
    /// Squared distances of the k nearest, as a heap whose largest is the first; the number found is returned.
    std::uint32_t nearest(Vec3 p, std::uint32_t k, float max_d2, float* heap) const;

private:
    void balance(std::vector<photon::Photon>& photons, std::size_t node, std::size_t first, std::size_t count);
    [[nodiscard]] int axis(std::size_t node) const { return photons_[node].time; }

    std::vector<photon::Photon> photons_;  ///< from 1 on; children of i are 2i and 2i + 1; `time` holds the axis
};

}  // namespace cardioid::bench
