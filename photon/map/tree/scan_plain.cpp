#include <algorithm>
#include <cmath>
#include <limits>

#include "photon/map/tree/scan.hpp"

namespace cardioid::photon {

namespace {

/// Steps of encode_direction.
constexpr float step = 2.0F / 65534.0F;

/// dot(n, m)^2, the square of what m has across n, and length(m)^2, of the octahedron's point m that `bits` stand for;
/// the first is 0 where m is behind n.
struct Facing {
    float along2, across2, length2;
};
Facing facing(std::uint32_t bits, Vec3 n) {
    float u = static_cast<float>(bits & 0xFFFFU) * step - 1, v = static_cast<float>(bits >> 16) * step - 1;
    const float w = 1 - std::abs(u) - std::abs(v);
    const float fold = std::max(-w, 0.0F);
    u = u - std::copysign(fold, u);
    v = v - std::copysign(fold, v);
    const float along = std::max(u * n.x + v * n.y + w * n.z, 0.0F);
    const float x = u - along * n.x, y = v - along * n.y, z = w - along * n.z;
    return {along * along, x * x + y * y + z * z, u * u + v * v + w * w};
}

/// What is left to test of a point that is near enough: its distance in the query's metric, or infinity.
float tested(const PointGroup& group, std::uint32_t lane, const ScanQuery& q, float distance2) {
    constexpr float refused = std::numeric_limits<float>::infinity();
    const float true_distance2 = distance2;
    float height2 = 0;
    if (q.test_height) {
        const float dx = group.x[lane] - q.p.x, dy = group.y[lane] - q.p.y, dz = group.z[lane] - q.p.z;
        const float height = dx * q.n.x + dy * q.n.y + dz * q.n.z;
        height2 = height * height;
        if (!(height2 <= std::max(q.slack2, q.steep_share * distance2))) return refused;
        distance2 = distance2 + q.stretch * height2;
    }
    if (q.test_region && group.region[lane] != q.region) return refused;
    if (q.test_normal) {
        const Facing f = facing(group.n[lane], q.n);
        if (!(f.along2 > 0 && f.along2 >= q.least_cos2 * f.length2)) return refused;
        if (q.test_bend) {
            const float allowed = (most_bend2 * f.across2 + bend_slack2 * f.length2) * true_distance2;
            if (!(height2 * f.length2 <= std::max(q.slack2 * f.length2, allowed))) return refused;
        }
    }
    return distance2;
}

std::uint32_t scan(const PointGroup* groups, Bucket bucket, const ScanQuery& q, float r2, float* d2,
                   std::uint32_t* index) noexcept {
    std::uint32_t found = 0;
    const std::uint32_t last = bucket.first + bucket.count;
    for (std::uint32_t block = bucket.first / PointGroup::size; block * PointGroup::size < last; ++block) {
        const PointGroup& group = groups[block];
        float near2[PointGroup::size];
        for (std::uint32_t lane = 0; lane < PointGroup::size; ++lane) {  // as a loop of its own, compilers see vectors
            const float dx = group.x[lane] - q.p.x, dy = group.y[lane] - q.p.y, dz = group.z[lane] - q.p.z;
            near2[lane] = dx * dx + dy * dy + dz * dz;
        }
        const std::uint32_t begin = block * PointGroup::size;
        for (std::uint32_t i = std::max(begin, bucket.first); i < std::min(begin + PointGroup::size, last); ++i) {
            if (!(near2[i - begin] < r2)) continue;
            const float distance2 = tested(group, i - begin, q, near2[i - begin]);
            if (!(distance2 < r2)) continue;
            d2[found] = distance2;
            index[found++] = i;
        }
    }
    return found;
}

float keep_smallest(float* d2, std::uint32_t* index, std::uint32_t n, std::uint32_t k) noexcept {
    float sorted[Neighbours::room];
    std::copy(d2, d2 + n, sorted);
    std::nth_element(sorted, sorted + (k - 1), sorted + n);
    const float largest = sorted[k - 1];
    std::uint32_t kept = 0, farthest = 0;
    for (std::uint32_t i = 0; i < n; ++i) {
        if (d2[i] > largest) continue;
        if (d2[i] == largest) farthest = kept;
        index[kept] = index[i];
        d2[kept++] = d2[i];
    }
    if (kept > k) farthest = drop_surplus(d2, index, kept, k);
    put_last(d2, index, farthest, k - 1);
    return largest;
}

}  // namespace

const ScanKernels plain_kernels{"plain", scan, keep_smallest};

std::uint32_t drop_surplus(float* d2, std::uint32_t* index, std::uint32_t n, std::uint32_t k) noexcept {
    const float largest = *std::max_element(d2, d2 + n);
    auto equal = static_cast<std::uint32_t>(std::count(d2, d2 + n, largest)) - (n - k);
    std::uint32_t kept = 0, farthest = 0;
    for (std::uint32_t i = 0; i < n; ++i) {
        if (d2[i] == largest) {
            if (equal == 0) continue;
            --equal;
            farthest = kept;
        }
        index[kept] = index[i];
        d2[kept++] = d2[i];
    }
    return farthest;
}

ScanQuery::ScanQuery(const PointQuery& g) noexcept
    : p(g.p),
      n(g.n),
      stretch(g.flatten * g.flatten - 1),
      // height^2 <= s^2 (distance^2 - height^2)
      steep_share(std::isinf(g.steepness) ? 1 : g.steepness * g.steepness / (1 + g.steepness * g.steepness)),
      slack2(std::isinf(g.steepness) ? std::numeric_limits<float>::infinity() : g.slack * g.slack),
      least_cos2(g.least_cos * g.least_cos),
      region(g.region),
      test_height(!std::isinf(g.steepness) || g.flatten != 1),
      test_normal(g.least_cos >= 0),
      test_bend(test_normal && !std::isinf(g.steepness)),
      test_region(g.region != FaceId::none) {}

}  // namespace cardioid::photon
