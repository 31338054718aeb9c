#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "photon/map/tree/point_query.hpp"

namespace cardioid::photon {

/// Sixteen points, a column a cache line: point i of a tree is number i % 16 of group i / 16.
struct alignas(64) PointGroup {
    static constexpr std::uint32_t size = 16;
    float x[size], y[size], z[size];
    std::uint32_t n[size];       ///< encode_direction
    std::uint32_t region[size];  ///< FaceId::region
};
static_assert(sizeof(PointGroup) == std::size_t{20} * PointGroup::size);

/// Consecutive points of a tree.
struct Bucket {
    std::uint32_t first, count;
};

/// A PointQuery with what all its points have in common worked out.
struct ScanQuery {
    explicit ScanQuery(const PointQuery& query) noexcept;
    Vec3 p, n;
    float stretch;      ///< flatten^2 - 1
    float steep_share;  ///< of the squared distance that a squared height may have
    float slack2;       ///< squared height that is always allowed
    float least_cos2;   ///< squared cosine of normals
    std::uint32_t region;
    bool test_height;  ///< whether steepness or flatten have any effect
    bool test_normal;  ///< whether least_cos has
    bool test_bend;    ///< whether steepness and least_cos have
    bool test_region;  ///< whether region has
};

/// Appends the points of a bucket that pass every test and are nearer than sqrt(r2) to d2 and index, in their order;
/// returns how many. Up to 15 places past the last may be overwritten.
using ScanBucket = std::uint32_t (*)(const PointGroup* groups, Bucket bucket, const ScanQuery& query, float r2,
                                     float* d2, std::uint32_t* index) noexcept;
/// Keeps the k smallest of n distances with their indices, of equal ones the first; returns the largest that was kept,
/// the last of which changes places with the last of all. Otherwise they keep their order. 1 <= k <= n <=
/// Neighbours::room - 64; what lies up to 15 places past the n-th is read.
using KeepSmallest = float (*)(float* d2, std::uint32_t* index, std::uint32_t n, std::uint32_t k) noexcept;

/// The inner loops for one kind of processor. All kinds give the same bits: same operations in the same order, no FMA.
struct ScanKernels {
    const char* name;
    ScanBucket scan;
    KeepSmallest keep_smallest;
};
extern const ScanKernels plain_kernels;
#if defined(__x86_64__)
extern const ScanKernels avx2_kernels, avx512_kernels;
#endif
/// Of n distances, the largest of which are equal, keeps k by dropping the last of those; returns the place of the last
/// largest that is left.
std::uint32_t drop_surplus(float* d2, std::uint32_t* index, std::uint32_t n, std::uint32_t k) noexcept;
inline void put_last(float* d2, std::uint32_t* index, std::uint32_t i, std::uint32_t last) noexcept {
    std::swap(d2[i], d2[last]);
    std::swap(index[i], index[last]);
}

/// What this processor can run, the quickest first; `plain_kernels` is the last.
[[nodiscard]] std::span<const ScanKernels> usable_kernels() noexcept;

}  // namespace cardioid::photon
