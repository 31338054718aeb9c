#pragma once
/// The inner loops in terms of vectors, for files that define before CARDIOID_VECTOR, the attributes of a function for
/// their kind of processor, and V, the operations on its vectors. No lambdas: those would lack the attributes.
#include <bit>
#include <cmath>

#include "photon/map/tree/scan.hpp"

namespace cardioid::photon {

namespace {

constexpr float octahedron_step = 2.0F / 65534.0F;

/// The lanes whose normals pass the query's tests, for what is so high over its plane and so far.
CARDIOID_VECTOR unsigned facing(const std::uint32_t* bits, const ScanQuery& q, V::F height2, V::F distance2) {
    const V::F one = V::all(1), step = V::all(octahedron_step);
    V::F u = V::low_half(bits) * step - one, v = V::high_half(bits) * step - one;
    const V::F w = one - V::abs(u) - V::abs(v);
    const V::F fold = V::max(V::all(0) - w, V::all(0));
    u = u - V::with_sign(fold, u);
    v = v - V::with_sign(fold, v);
    const V::F along = u * V::all(q.n.x) + v * V::all(q.n.y) + w * V::all(q.n.z);
    const V::F length2 = u * u + v * v + w * w;
    const V::F along2 = along * along;
    const unsigned lanes = V::less(V::all(0), along) & V::at_most(V::all(q.least_cos2) * length2, along2);
    if (!q.test_bend) return lanes;
    const V::F x = u - along * V::all(q.n.x), y = v - along * V::all(q.n.y), z = w - along * V::all(q.n.z);
    const V::F across2 = x * x + y * y + z * z;
    const V::F allowed = (V::all(most_bend2) * across2 + V::all(bend_slack2) * length2) * distance2;
    return lanes & V::at_most(height2 * length2, V::max(V::all(q.slack2) * length2, allowed));
}

/// The lanes of the block of V::size points from `block` on that belong to the bucket.
CARDIOID_VECTOR unsigned lanes_of(Bucket bucket, std::uint32_t block) {
    constexpr unsigned all = (1U << V::size) - 1;
    const std::uint32_t last = bucket.first + bucket.count;
    unsigned lanes = all;
    if (block < bucket.first) lanes &= all << (bucket.first - block);
    if (last - block < V::size) lanes &= all >> (V::size - (last - block));
    return lanes;
}

CARDIOID_VECTOR std::uint32_t scan(const PointGroup* groups, Bucket bucket, const ScanQuery& q, float r2, float* d2,
                                   std::uint32_t* index) noexcept {
    const V::F px = V::all(q.p.x), py = V::all(q.p.y), pz = V::all(q.p.z), limit = V::all(r2);
    std::uint32_t found = 0;
    for (std::uint32_t block = bucket.first / V::size * V::size; block < bucket.first + bucket.count;
         block += V::size) {
        const PointGroup& group = groups[block / PointGroup::size];
        const std::uint32_t lane = block % PointGroup::size;
        const V::F dx = V::load(group.x + lane) - px, dy = V::load(group.y + lane) - py,
                   dz = V::load(group.z + lane) - pz;
        const V::F true_distance2 = dx * dx + dy * dy + dz * dz;
        V::F distance2 = true_distance2, height2 = V::all(0);
        unsigned lanes = lanes_of(bucket, block);
        if (q.test_height) {
            const V::F height = dx * V::all(q.n.x) + dy * V::all(q.n.y) + dz * V::all(q.n.z);
            height2 = height * height;
            lanes &= V::at_most(height2, V::max(V::all(q.slack2), V::all(q.steep_share) * distance2));
            distance2 = distance2 + V::all(q.stretch) * height2;
        }
        lanes &= V::less(distance2, limit);
        if (lanes == 0) continue;
        if (q.test_region) lanes &= V::equal(group.region + lane, q.region);
        if (q.test_normal) lanes &= facing(group.n + lane, q, height2, true_distance2);
        V::compress(d2 + found, distance2, lanes);
        V::compress(index + found, V::count_from(block), lanes);
        found += static_cast<std::uint32_t>(__builtin_popcount(lanes));
    }
    return found;
}

/// The lanes of the vector that begins at place i of n which there are.
CARDIOID_VECTOR unsigned lanes_before(std::uint32_t n, std::uint32_t i) {
    constexpr unsigned all = (1U << V::size) - 1;
    return n - i < V::size ? (1U << (n - i)) - 1 : all;
}

CARDIOID_VECTOR std::uint32_t count_below(const float* d2, std::uint32_t n, float limit) {
    std::uint32_t count = 0;
    for (std::uint32_t i = 0; i < n; i += V::size)
        count += static_cast<std::uint32_t>(
            __builtin_popcount(V::less(V::load(d2 + i), V::all(limit)) & lanes_before(n, i)));
    return count;
}

CARDIOID_VECTOR float largest_below(const float* d2, std::uint32_t n, float limit) {
    V::F most = V::all(-1);
    for (std::uint32_t i = 0; i < n; i += V::size) {
        const V::F x = V::load(d2 + i);
        most = V::max(most, V::select(V::less(x, V::all(limit)) & lanes_before(n, i), x, V::all(-1)));
    }
    return V::most(most);
}

/// Looks for a limit with k distances below it: first where it would be if squared distances were spread evenly, as on
/// a surface they nearly are; where they are not, by halving the floats between, of which there are less than 2^31.
CARDIOID_VECTOR float kth_smallest(const float* d2, std::uint32_t n, std::uint32_t k) {
    constexpr int even_rounds = 8;
    float lo = 0, hi = std::nextafter(largest_below(d2, n, HUGE_VALF), HUGE_VALF);
    std::uint32_t below_lo = 0, below_hi = n;
    for (int round = 0; below_hi != k; ++round) {
        float limit = lo + (hi - lo) * (static_cast<float>(k - below_lo) / static_cast<float>(below_hi - below_lo));
        if (round >= even_rounds || !(limit > lo && limit < hi)) {
            const auto lo_bits = std::bit_cast<std::uint32_t>(lo), hi_bits = std::bit_cast<std::uint32_t>(hi);
            if (hi_bits - lo_bits <= 1) break;  // several are the k-th
            limit = std::bit_cast<float>(lo_bits + (hi_bits - lo_bits) / 2);
        }
        const std::uint32_t below = count_below(d2, n, limit);
        (below >= k ? hi : lo) = limit;
        (below >= k ? below_hi : below_lo) = below;
    }
    return largest_below(d2, n, hi);
}

/// The place that the last lane of `chosen` gets when `lanes` are put one after the other.
CARDIOID_VECTOR std::uint32_t last_of(unsigned lanes, unsigned chosen) {
    const unsigned up_to = std::bit_ceil(chosen + 1) - 1;
    return static_cast<std::uint32_t>(__builtin_popcount(lanes & up_to)) - 1;
}

CARDIOID_VECTOR float keep_smallest(float* d2, std::uint32_t* index, std::uint32_t n, std::uint32_t k) noexcept {
    const float largest = kth_smallest(d2, n, k);
    std::uint32_t kept = 0, farthest = 0;
    for (std::uint32_t i = 0; i < n; i += V::size) {
        const V::F x = V::load(d2 + i);
        const unsigned lanes = V::at_most(x, V::all(largest)) & lanes_before(n, i);
        const unsigned nearer = V::less(x, V::all(largest)) & lanes;
        if (nearer != lanes) farthest = kept + last_of(lanes, lanes & ~nearer);
        V::compress(index + kept, V::load(index + i), lanes);
        V::compress(d2 + kept, x, lanes);
        kept += static_cast<std::uint32_t>(__builtin_popcount(lanes));
    }
    if (kept > k) farthest = drop_surplus(d2, index, kept, k);
    put_last(d2, index, farthest, k - 1);
    return largest;
}

}  // namespace

}  // namespace cardioid::photon
