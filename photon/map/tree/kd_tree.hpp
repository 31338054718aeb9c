#pragma once
#include <algorithm>
#include <vector>

#include "photon/map/tree/kd_build.hpp"
#include "photon/map/tree/kd_reach.hpp"

namespace cardioid::photon {

/// Takes every point.
struct KeepAll {
    bool operator()(std::uint32_t /*index*/, float /*d2*/) const noexcept { return true; }
};

/// A kd-tree over places of surfaces (position, normal, region); what else there is of a point, PointTree keeps.
/// Read-only once built: any thread may query it. A query costs O(log n + points looked at).
/// Bucketed with candidates cut back by selection instead of a heap; after Wald, Guenther, Slusallek 2004 in the
/// splits.
class KdTree {
public:
    KdTree() = default;
    /// Throws what lay_out_kd throws. `normal` and `region` are called with the caller's indices, on several threads.
    template <class Normal, class Region>
    KdTree(KdLayout&& layout, const Normal& normal, const Region& region);

    [[nodiscard]] std::uint32_t size() const noexcept { return size_; }
    [[nodiscard]] Vec3 position(std::uint32_t i) const noexcept {
        const PointGroup& g = group(i);
        return {g.x[i % PointGroup::size], g.y[i % PointGroup::size], g.z[i % PointGroup::size]};
    }
    /// encode_direction.
    [[nodiscard]] std::uint32_t normal(std::uint32_t i) const noexcept { return group(i).n[i % PointGroup::size]; }
    [[nodiscard]] std::uint32_t region(std::uint32_t i) const noexcept { return group(i).region[i % PointGroup::size]; }
    /// Box around all points; both are zero without points.
    [[nodiscard]] Vec3 lo() const noexcept { return lo_; }
    [[nodiscard]] Vec3 hi() const noexcept { return hi_; }
    [[nodiscard]] std::span<const KdNode> nodes() const noexcept { return nodes_; }
    [[nodiscard]] std::size_t memory_bytes() const noexcept {
        return nodes_.capacity() * sizeof(KdNode) + groups_.capacity() * sizeof(PointGroup);
    }

    /// The min(k, max_k) nearest of the points that pass the query's tests and keep(index, d2); fewer where there are
    /// not as many within its radius. Of points at the same distance any may come first, the same at every call.
    template <class Keep = KeepAll>
    void nearest(const PointQuery& query, std::uint32_t k, Neighbours& out, const Keep& keep = {}) const noexcept;
    /// The nearest of them.
    template <class Keep = KeepAll>
    [[nodiscard]] Nearest nearest(const PointQuery& query, const Keep& keep = {}) const noexcept;
    /// Calls visit(index, d2) for every point within the radius that passes the tests, in the order of the tree's walk.
    template <class Visit>
    void visit_within(const PointQuery& query, const Visit& visit) const noexcept;
    /// Calls visit(index, d2, r2) for every point that reaches the query's place, r being its reach, and passes the
    /// tests; the query's radius is not read.
    template <class Visit>
    void visit_reaching(const PointQuery& query, const KdReach& reach, const Visit& visit) const noexcept;

    /// Has this tree use other inner loops than the quickest; for tests and benchmarks.
    void use(const ScanKernels& kernels) noexcept { kernels_ = &kernels; }

private:
    [[nodiscard]] const PointGroup& group(std::uint32_t i) const noexcept { return groups_[i / PointGroup::size]; }
    /// Calls look(bucket) for the buckets that may hold points nearer than sqrt(r2), near ones first; look returns r2
    /// anew.
    template <class Look>
    void walk(Vec3 p, float r2, const Look& look) const noexcept;

    std::vector<KdNode> nodes_;
    UntouchedVector<PointGroup> groups_;
    std::uint32_t size_ = 0;
    Vec3 lo_, hi_;
    const ScanKernels* kernels_ = &usable_kernels().front();
};

}  // namespace cardioid::photon

#include "photon/map/tree/kd_tree_impl.hpp"  // IWYU pragma: keep
