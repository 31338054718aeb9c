#include "csg/bvh/bvh8.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace cardioid::csg {
namespace {

constexpr int bin_count = 16;

double half_area(const Box3d& b) {
    if (b.empty()) return 0;
    const Vec3d s = b.size();
    return s.x * s.y + s.y * s.z + s.z * s.x;
}

/// Where to cut: the axis and the bin before which the surface area heuristic is least; axis -1 where all centres
/// agree.
struct Cut {
    int axis = -1;
    int bin = 0;
    double lo = 0, scale = 0;
    [[nodiscard]] int bin_of(const Box3d& b) const {
        return std::min(bin_count - 1, static_cast<int>((b.centre()[axis] - lo) * scale));
    }
};

Cut best_cut(std::span<const Box3d> boxes, std::span<const std::uint32_t> members, const Box3d& centres) {
    Cut best;
    double best_cost = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        const double width = centres.hi[axis] - centres.lo[axis];
        if (!(width > 0)) continue;
        const Cut cut{axis, 0, centres.lo[axis], bin_count * (1 - 1e-9) / width};
        std::array<Box3d, bin_count> bin_box;
        std::array<double, bin_count> bin_size{};
        for (const std::uint32_t m : members) {
            const auto bin = static_cast<std::size_t>(cut.bin_of(boxes[m]));
            bin_box[bin].include(boxes[m]);
            bin_size[bin] += 1;
        }
        std::array<double, bin_count> right_cost{};
        Box3d right;
        double count = 0;
        for (std::size_t i = bin_count; i-- > 1;) {
            right.include(bin_box[i]);
            right_cost[i] = (count += bin_size[i]) * half_area(right);
        }
        Box3d left;
        count = 0;
        for (std::size_t i = 1; i < bin_count; ++i) {
            left.include(bin_box[i - 1]);
            count += bin_size[i - 1];
            const double cost = count * half_area(left) + right_cost[i];
            if (cost < best_cost) best_cost = cost, best = cut, best.bin = static_cast<int>(i);
        }
    }
    return best;
}

}  // namespace

Bvh8::Range Bvh8::range(std::span<const Box3d> boxes, std::uint32_t first, std::uint32_t count) const {
    Range r{first, count, {}};
    for (std::uint32_t i = first; i < first + count; ++i) r.box.include(boxes[order_[i]]);
    return r;
}

/// Reorders the range and returns where its second half begins; both halves are non-empty.
std::uint32_t Bvh8::split(std::span<const Box3d> boxes, const Range& r) {
    const auto begin = order_.begin() + r.first, end = begin + r.count;
    Box3d centres;
    std::for_each(begin, end, [&](std::uint32_t m) { centres.include(boxes[m].centre()); });
    const Cut cut = best_cut(boxes, {begin, end}, centres);
    if (cut.axis >= 0) {
        const auto middle =
            std::stable_partition(begin, end, [&](std::uint32_t m) { return cut.bin_of(boxes[m]) < cut.bin; });
        if (middle != begin && middle != end) return static_cast<std::uint32_t>(middle - order_.begin());
    }
    return r.first + r.count / 2;
}

std::uint32_t Bvh8::build(std::span<const Box3d> boxes, const Range& r, std::uint32_t leaf_size, double pad) {
    std::vector<Range> parts{r};
    while (parts.size() < 8) {
        const auto widest = std::max_element(parts.begin(), parts.end(), [&](const Range& a, const Range& b) {
            return (a.count > leaf_size ? half_area(a.box) + 1e-300 : -1) <
                   (b.count > leaf_size ? half_area(b.box) + 1e-300 : -1);
        });
        if (widest->count <= leaf_size) break;
        const Range whole = *widest;
        const std::uint32_t middle = split(boxes, whole);
        *widest = range(boxes, whole.first, middle - whole.first);
        parts.push_back(range(boxes, middle, whole.first + whole.count - middle));
    }
    const auto index = static_cast<std::uint32_t>(nodes_.size());
    nodes_.emplace_back();
    for (std::size_t i = 0; i < 8; ++i) {
        const bool used = i < parts.size();
        const Box3d box = used ? parts[i].box.padded(pad) : Box3d{};
        const std::uint32_t child = !used                         ? leaf_flag
                                    : parts[i].count <= leaf_size ? leaf_flag | parts[i].first << 3 | parts[i].count
                                                                  : build(boxes, parts[i], leaf_size, pad);
        BvhNode& node = nodes_[index];
        for (int axis = 0; axis < 3; ++axis) {
            node.lo[axis][i] = static_cast<float>(box.lo[axis] - (used ? centre_[axis] : 0));
            node.hi[axis][i] = static_cast<float>(box.hi[axis] - (used ? centre_[axis] : 0));
        }
        node.child[i] = child;
    }
    return index;
}

Bvh8::Bvh8(std::span<const Box3d> boxes, std::uint32_t leaf_size) {
    if (boxes.empty()) return;
    order_.resize(boxes.size());
    std::iota(order_.begin(), order_.end(), 0U);
    const Range all = range(boxes, 0, static_cast<std::uint32_t>(boxes.size()));
    centre_ = all.box.centre();
    build(boxes, all, leaf_size, 1e-6 * all.box.diagonal());
    nodes_.shrink_to_fit();
}

}  // namespace cardioid::csg
