#include "bench/photon_octree.hpp"

#include <algorithm>

#include "bench/nearest_heap.hpp"

namespace cardioid::bench {

using photon::Photon;

namespace {

constexpr std::size_t few = 16;
constexpr int deepest = 24;

}  // namespace

PhotonOctree::PhotonOctree(std::vector<Photon> photons) : photons_(std::move(photons)), nodes_(1) {
    if (photons_.empty()) {
        nodes_[0].count = 0;
        return;
    }
    Vec3 lo = photons_[0].p, hi = lo;
    for (const Photon& photon : photons_) lo = min(lo, photon.p), hi = max(hi, photon.p);
    root_ = {lo, max_component(hi - lo)};
    split(0, root_, 0, photons_.size(), 0);
}

PhotonOctree::Cell PhotonOctree::child(const Cell& cell, unsigned part) {
    const float half = cell.size / 2;
    return {cell.lo + Vec3{part & 1 ? half : 0, part & 2 ? half : 0, part & 4 ? half : 0}, half};
}

void PhotonOctree::split(std::size_t node, const Cell& cell, std::size_t first, std::size_t count, int depth) {
    if (count <= few || depth == deepest) {
        nodes_[node] = {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(count)};
        return;
    }
    const std::size_t children = nodes_.size();
    nodes_[node].first = static_cast<std::uint32_t>(children);
    nodes_.resize(children + 8);
    const Cell upper = child(cell, 7);
    const auto part_of = [&upper](const Photon& photon) {
        const Vec3 p = photon.p;
        return (p.x >= upper.lo.x ? 1U : 0U) | (p.y >= upper.lo.y ? 2U : 0U) | (p.z >= upper.lo.z ? 4U : 0U);
    };
    auto begin = photons_.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = begin + static_cast<std::ptrdiff_t>(count);
    for (unsigned part = 0; part < 8; ++part) {
        const auto next = std::partition(begin, end, [&](const Photon& photon) { return part_of(photon) == part; });
        split(children + part, child(cell, part), static_cast<std::size_t>(begin - photons_.begin()),
              static_cast<std::size_t>(next - begin), depth + 1);
        begin = next;
    }
}

struct PhotonOctree::Search {
    Vec3 p;
    std::uint32_t k;
    float max_d2;
    float* heap;
    std::uint32_t found = 0;

    [[nodiscard]] float distance2(const Cell& cell) const {
        const Vec3 hi = cell.lo + Vec3{cell.size, cell.size, cell.size};
        const Vec3 d = max(max(cell.lo - p, p - hi), Vec3{});
        return dot(d, d);
    }
};

void PhotonOctree::search(std::uint32_t node, const Cell& cell, Search& s) const {
    const Node at = nodes_[node];
    if (at.count != Node::inner) {
        for (std::uint32_t i = at.first; i < at.first + at.count; ++i) {
            const Vec3 d = photons_[i].p - s.p;
            const float d2 = dot(d, d);
            if (!(d2 < s.max_d2)) continue;
            keep_nearest(s.heap, s.found, s.k, d2);
            if (s.found == s.k) s.max_d2 = s.heap[0];
        }
        return;
    }
    struct Child {
        float d2;
        unsigned part;
    };
    Child children[8];
    int near = 0;
    for (unsigned part = 0; part < 8; ++part) {
        if (nodes_[at.first + part].count == 0) continue;
        const float d2 = s.distance2(child(cell, part));
        if (!(d2 < s.max_d2)) continue;
        int i = near++;
        for (; i > 0 && children[i - 1].d2 > d2; --i) children[i] = children[i - 1];
        children[i] = {d2, part};
    }
    for (int i = 0; i < near && children[i].d2 < s.max_d2; ++i)
        search(at.first + children[i].part, child(cell, children[i].part), s);
}

std::uint32_t PhotonOctree::nearest(Vec3 p, std::uint32_t k, float max_d2, float* heap) const {
    Search s{p, k, max_d2, heap};
    search(0, root_, s);
    return s.found;
}

}  // namespace cardioid::bench
