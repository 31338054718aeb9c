#pragma once
#include <vector>

#include "photon/map/photon.hpp"

namespace cardioid::bench {

/// What ARL-TR-3608 weighs the kd-tree against (note [2]): an octree of whole photons, up to 16 to a leaf, the nearest
/// kept in a heap as in PhotonHeap.
class PhotonOctree {
public:
    explicit PhotonOctree(std::vector<photon::Photon> photons);
    /// As PhotonHeap::nearest.
    std::uint32_t nearest(Vec3 p, std::uint32_t k, float max_d2, float* heap) const;

private:
    struct Node {
        std::uint32_t first = 0;  ///< photon, or the first of eight children
        std::uint32_t count = inner;
        static constexpr std::uint32_t inner = 0xFFFFFFFFU;
    };
    struct Cell {
        Vec3 lo;
        float size;
    };
    struct Search;

    void split(std::size_t node, const Cell& cell, std::size_t first, std::size_t count, int depth);
    static Cell child(const Cell& cell, unsigned part);
    void search(std::uint32_t node, const Cell& cell, Search& s) const;

    std::vector<photon::Photon> photons_;  ///< those of a leaf side by side
    std::vector<Node> nodes_;
    Cell root_{};
};

}  // namespace cardioid::bench
