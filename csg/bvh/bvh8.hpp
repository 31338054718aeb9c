#pragma once
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "rt_core/math/box.hpp"

namespace cardioid::csg {

/// Eight boxes side by side, so that one instruction tests a plane of all of them. 224 bytes.
struct alignas(32) BvhNode {
    float lo[3][8], hi[3][8];
    std::uint32_t child[8];  ///< a node, or Bvh8::leaf_flag | first << 3 | count
};

/// A ray as the box test wants it, relative to Bvh8::centre.
struct BoxRay {
    Vec3 o, inverse_d;
    /// d may have zeros; then the inverse is huge but finite, so that 0 * inverse is no NaN.
    BoxRay(Vec3 origin, Vec3 d) : o(origin), inverse_d(inverse(d.x), inverse(d.y), inverse(d.z)) {}

private:
    static float inverse(float x) { return std::abs(x) < 1e-30F ? std::copysign(1e30F, x) : 1 / x; }
};

/// Bit i is set where the ray meets box i within [t_min, t_max]; entry[i] is then where. entry is 32-byte aligned.
using HitBoxes = unsigned (*)(const BvhNode&, const BoxRay&, float t_min, float t_max, float* entry) noexcept;
/// The quickest version this processor has; all give the same results.
extern const HitBoxes hit_boxes;
/// The plain version, for tests.
unsigned hit_boxes_plain(const BvhNode&, const BoxRay&, float t_min, float t_max, float* entry) noexcept;

/// A hierarchy of boxes, eight children a node, split by the surface area heuristic (Wald, Boulos, Shirley 2007).
/// Boxes are rounded outwards, with room for the rounding of float rays. Building is O(n log n).
class Bvh8 {
public:
    static constexpr std::uint32_t leaf_flag = 0x80000000U;
    static constexpr std::uint32_t max_leaf = 7;

    Bvh8() = default;
    /// Bounded, non-empty boxes; leaves hold up to `leaf_size` <= max_leaf of them.
    Bvh8(std::span<const Box3d> boxes, std::uint32_t leaf_size);

    [[nodiscard]] bool empty() const { return nodes_.empty(); }
    [[nodiscard]] const BvhNode& node(std::uint32_t i) const { return nodes_[i]; }
    /// The boxes' numbers in the order of the leaves: a leaf is order()[first .. first + count).
    [[nodiscard]] const std::vector<std::uint32_t>& order() const { return order_; }
    [[nodiscard]] Vec3d centre() const { return centre_; }
    [[nodiscard]] std::size_t memory_bytes() const {
        return nodes_.capacity() * sizeof(BvhNode) + order_.capacity() * sizeof(std::uint32_t);
    }

private:
    struct Range {
        std::uint32_t first, count;
        Box3d box;
    };
    [[nodiscard]] Range range(std::span<const Box3d> boxes, std::uint32_t first, std::uint32_t count) const;
    [[nodiscard]] std::uint32_t split(std::span<const Box3d> boxes, const Range& r);
    std::uint32_t build(std::span<const Box3d> boxes, const Range& r, std::uint32_t leaf_size, double pad);

    std::vector<BvhNode> nodes_;
    std::vector<std::uint32_t> order_;
    Vec3d centre_;
};

}  // namespace cardioid::csg
