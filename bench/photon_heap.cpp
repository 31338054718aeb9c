#include "bench/photon_heap.hpp"

#include <algorithm>
#include <bit>

#include "bench/nearest_heap.hpp"

namespace cardioid::bench {

using photon::Photon;

PhotonHeap::PhotonHeap(std::vector<Photon> photons) : photons_(photons.size() + 1) {
    balance(photons, 1, 0, photons.size());
}

void PhotonHeap::balance(std::vector<Photon>& photons, std::size_t node, std::size_t first, std::size_t count) {
    if (count == 0) return;
    Vec3 lo = photons[first].p, hi = lo;
    for (std::size_t i = first; i < first + count; ++i) lo = min(lo, photons[i].p), hi = max(hi, photons[i].p);
    const Vec3 size = hi - lo;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    // The left side of a complete tree: its full levels, and of the lowest one what comes first.
    const std::size_t full = std::bit_floor(count);
    const std::size_t left = count == 1 ? 0 : (full - 2) / 2 + std::min(count - full + 1, full / 2);
    const auto at = photons.begin() + static_cast<std::ptrdiff_t>(first);
    std::nth_element(at, at + static_cast<std::ptrdiff_t>(left), at + static_cast<std::ptrdiff_t>(count),
                     [axis](const Photon& a, const Photon& b) { return a.p[axis] < b.p[axis]; });
    photons_[node] = photons[first + left];
    photons_[node].time = static_cast<std::uint16_t>(axis);
    balance(photons, 2 * node, first, left);
    balance(photons, 2 * node + 1, first + left + 1, count - left - 1);
}

std::uint32_t PhotonHeap::nearest(Vec3 p, std::uint32_t k, float max_d2, float* heap) const {
    struct Pending {
        std::size_t node;
        float beyond2;  ///< squared distance to the node's plane, or 0 on the way down
    };
    Pending stack[64];
    int pending = 0;
    std::uint32_t found = 0;
    stack[pending++] = {1, 0};
    while (pending > 0) {
        const Pending top = stack[--pending];
        if (top.beyond2 >= max_d2) continue;
        for (std::size_t node = top.node; node < photons_.size();) {
            const Photon& photon = photons_[node];
            const Vec3 d = photon.p - p;
            const float d2 = dot(d, d);
            if (d2 < max_d2) {
                keep_nearest(heap, found, k, d2);
                if (found == k) max_d2 = heap[0];
            }
            const float beyond = p[axis(node)] - photon.p[axis(node)];
            const std::size_t near = 2 * node + (beyond >= 0), far = near ^ 1;
            if (far < photons_.size() && beyond * beyond < max_d2) stack[pending++] = {far, beyond * beyond};
            node = near;
        }
    }
    return found;
}

}  // namespace cardioid::bench
