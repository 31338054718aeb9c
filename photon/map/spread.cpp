#include "photon/map/spread.hpp"

#include <cmath>

#include "rt_core/api/parallel.hpp"

namespace cardioid::photon {

namespace {

/// How fast discs may grow from place to place, for a unit of distance: discs beside an edge of light do not cover it.
constexpr float slope = 0.35F;

/// A node whose photons share a size.
struct Patch {
    std::size_t node;
    Bucket photons;
};

/// The photon in the middle of a patch, as a point of a tree.
struct PatchPoint {
    Vec3 p;
    std::uint32_t n, region;
    float radius;  ///< of the discs
};
float payload_of(const PatchPoint& point) { return point.radius; }

class Spreader {
public:
    Spreader(const PhotonMap& map, const LookupRule& rule)
        : map_(map), tree_(map.tree()), rule_(rule), ranges_(tree_.nodes().size()), reach_(tree_.nodes().size()) {}

    KdReach spread() {
        if (ranges_.empty()) return std::move(reach_);
        find_ranges(0);
        find_patches(0);
        std::vector<PatchPoint> points(patches_.size());
        for_each_patch([&](std::size_t i) {
            const std::uint32_t middle = middle_of(patches_[i].photons);
            points[i] = {tree_.position(middle), tree_.normal(middle), tree_.region(middle), radius_at(middle)};
        });
        const PointTree<PatchPoint> all(points);
        for_each_patch([&](std::size_t i) { set(patches_[i].node, limited(points[i], all)); });
        join(0);
        return std::move(reach_);
    }

private:
    template <class Body>
    void for_each_patch(const Body& body) const {
        constexpr std::size_t chunk = 64;
        const std::size_t n = patches_.size();
        parallel_for(static_cast<std::int64_t>((n + chunk - 1) / chunk), [&](std::int64_t c) {
            const std::size_t first = static_cast<std::size_t>(c) * chunk;
            for (std::size_t i = first; i < std::min(first + chunk, n); ++i) body(i);
        });
    }

    [[nodiscard]] std::size_t right_of(std::size_t node) const { return node + tree_.nodes()[node].right(); }

    Bucket find_ranges(std::size_t node) {
        if (tree_.nodes()[node].is_bucket()) return ranges_[node] = tree_.nodes()[node].bucket();
        const Bucket left = find_ranges(node + 1), right = find_ranges(right_of(node));
        return ranges_[node] = {left.first, left.count + right.count};
    }

    void find_patches(std::size_t node) {
        if (tree_.nodes()[node].is_bucket() || ranges_[node].count <= rule_.k / 16) {
            if (ranges_[node].count > 0) patches_.push_back({node, ranges_[node]});
            return;
        }
        find_patches(node + 1);
        find_patches(right_of(node));
    }

    void set(std::size_t node, float size) {
        reach_.set(node, size);
        if (tree_.nodes()[node].is_bucket()) return;
        set(node + 1, size);
        set(right_of(node), size);
    }

    float join(std::size_t node) {
        if (!tree_.nodes()[node].is_bucket()) reach_.set(node, std::max(join(node + 1), join(right_of(node))));
        return reach_[node];
    }

    /// The photon nearest to the middle of a patch.
    [[nodiscard]] std::uint32_t middle_of(Bucket photons) const {
        Vec3 sum;
        for (std::uint32_t i = 0; i < photons.count; ++i) sum += tree_.position(photons.first + i);
        const Vec3 middle = sum * (1 / static_cast<float>(photons.count));
        std::uint32_t best = photons.first;
        float least = HUGE_VALF;
        for (std::uint32_t i = photons.first; i < photons.first + photons.count; ++i) {
            const Vec3 away = tree_.position(i) - middle;
            if (dot(away, away) < least) least = dot(away, away), best = i;
        }
        return best;
    }

    /// Of the disc around photon i that holds k of them, and never more than max_radius. Between the two it passes
    /// smoothly: what is blurred away goes as the second derivative of brightness times area, so that a bend in the
    /// radius is a dark line (1.8 % at a radius of 0.25 and a slope of 0.9 of the light itself for a unit of distance).
    [[nodiscard]] float radius_at(std::uint32_t i) const {
        const PointQuery q = map_.query(tree_.position(i), decode_direction(tree_.normal(i)), tree_.region(i), rule_);
        Neighbours found;
        tree_.nearest(q, rule_.k, found);
        const float most2 = rule_.max_radius * rule_.max_radius;
        const bool few = found.size < rule_.k && std::isfinite(most2);
        const float holding2 =
            few ? most2 * (static_cast<float>(rule_.k) / static_cast<float>(found.size)) : found.d2[found.size - 1];
        const float share = holding2 / most2;
        const float radius = std::sqrt(holding2 / std::sqrt(1 + share * share));
        // Photons all at one place light a disc as small as places are known.
        return std::max(radius, std::max(q.slack, 0x1p-60F));
    }

    /// The radius of a patch, or less where there are smaller discs near by.
    [[nodiscard]] float limited(const PatchPoint& patch, const PointTree<PatchPoint>& all) const {
        PointQuery q = map_.query(patch.p, decode_direction(patch.n), patch.region, rule_);
        q.max_radius = patch.radius / slope;
        float radius = patch.radius;
        all.visit_within(
            q, [&](std::uint32_t i, float d2) { radius = std::min(radius, all.payload(i) + slope * std::sqrt(d2)); });
        return radius;
    }

    const PhotonMap& map_;
    const PointTree<Photon>& tree_;
    const LookupRule& rule_;
    std::vector<Bucket> ranges_;  ///< photons of each node
    std::vector<Patch> patches_;
    KdReach reach_;
};

}  // namespace

KdReach spread_photons(const PhotonMap& map, const LookupRule& rule) { return Spreader(map, rule).spread(); }

}  // namespace cardioid::photon
