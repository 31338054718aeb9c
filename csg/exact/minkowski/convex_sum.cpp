#include "csg/exact/minkowski/convex_sum.hpp"

#include <algorithm>
#include <utility>

#include "csg/exact/hull.hpp"
#include "csg/shapes/mesh_edges.hpp"

namespace cardioid::csg {

namespace {

/// Up to so many sums of corners, all of them are quicker than the choice of some.
constexpr double few_points = 4096;
/// Sums a corner or face that the choice starts with, and what its later rounds add, roughly.
constexpr double points_a_corner = 16;

double all_pairs(const ConvexPart& a, const ConvexPart& b) {
    return static_cast<double>(a.corners().size()) * static_cast<double>(b.corners().size());
}

bool takes_all_pairs(const ConvexPart& a, const ConvexPart& b) {
    return a.is_flat() || b.is_flat() || all_pairs(a, b) <= few_points;
}

TriangleMesh hull_of_all(const ConvexPart& a, const ConvexPart& b) {
    std::vector<Vec3d> sums;
    sums.reserve(a.corners().size() * b.corners().size());
    for (const Vec3d p : a.corners())
        for (const Vec3d q : b.corners()) sums.push_back(p + q);
    return convex_hull(sums);
}

Box3d box_of(const ConvexPart& part) {
    Box3d out;
    for (const Vec3d p : part.corners()) out.include(p);
    return out;
}

/// The choice of sums.
class Sum {
public:
    Sum(const ConvexPart& a, const ConvexPart& b) : a_(a), b_(b) {
        const Box3d of_a = box_of(a), of_b = box_of(b);
        const auto reach = [](const Box3d& box) { return max_component(max(abs(box.lo), abs(box.hi))); };
        rounding_ = 1e-14 * (reach(of_a) + reach(of_b));
    }

    TriangleMesh run() {
        over_faces(a_, b_, [&](std::uint32_t in_a, std::uint32_t in_b) { add(in_a, in_b); });
        over_faces(b_, a_, [&](std::uint32_t in_b, std::uint32_t in_a) { add(in_a, in_b); });
        keep_distinct();
        TriangleMesh hull = convex_hull(points_);
        while (add_beyond(hull)) hull = convex_hull(points_);
        return hull;
    }

private:
    void add(std::uint32_t in_a, std::uint32_t in_b) { points_.push_back(a_.corners()[in_a] + b_.corners()[in_b]); }

    /// Of every face of one, its corners with the other's farthest corner.
    template <class Add>
    static void over_faces(const ConvexPart& of, const ConvexPart& other, Add&& add) {
        std::uint32_t at = 0;
        for (std::size_t f = 0; f < of.faces().size(); ++f) {
            at = other.farthest(of.normal(f), at);
            for (const std::uint32_t corner : of.faces()[f]) add(corner, at);
        }
    }

    /// Adds the farthest point of the sum beyond each face of the hull; false where there is none that is new.
    bool add_beyond(const TriangleMesh& hull) {
        const std::size_t before = points_.size();
        std::uint32_t in_a = 0, in_b = 0;
        for (const auto& [p, q, r] : hull.triangles) {
            const Vec3d corner = hull.vertices[p];
            const Vec3d n = cross(hull.vertices[q] - corner, hull.vertices[r] - corner);
            in_a = a_.farthest(n, in_a);
            in_b = b_.farthest(n, in_b);
            if (dot(a_.corners()[in_a] + b_.corners()[in_b] - corner, n) > rounding_ * length(n)) add(in_a, in_b);
        }
        keep_distinct();
        return points_.size() > before;
    }

    void keep_distinct() {
        std::ranges::sort(points_, less);
        const auto same = std::ranges::unique(points_);
        points_.erase(same.begin(), same.end());
    }

    static bool less(Vec3d p, Vec3d q) {
        if (p.x != q.x) return p.x < q.x;
        return p.y != q.y ? p.y < q.y : p.z < q.z;
    }

    const ConvexPart& a_;
    const ConvexPart& b_;
    double rounding_ = 0;
    std::vector<Vec3d> points_;
};

}  // namespace

ConvexPart::ConvexPart(std::vector<Vec3d> points) : hull_(convex_hull(points)) {
    if (hull_.triangles.empty()) {
        hull_.vertices = std::move(points);
        return;
    }
    std::vector<std::pair<std::uint32_t, std::uint32_t>> both_ways;
    for_each_edge(hull_, [&](std::uint32_t p, std::uint32_t q, std::span<const HalfEdge>) {
        both_ways.emplace_back(p, q);
        both_ways.emplace_back(q, p);
    });
    std::ranges::sort(both_ways);
    first_.assign(hull_.vertices.size() + 1, 0);
    for (const auto& [from, to] : both_ways) {
        ++first_[from + 1];
        neighbours_.push_back(to);
    }
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
}

Vec3d ConvexPart::normal(std::size_t face) const {
    const auto& [p, q, r] = hull_.triangles[face];
    const Vec3d corner = hull_.vertices[p];
    return cross(hull_.vertices[q] - corner, hull_.vertices[r] - corner);
}

std::uint32_t ConvexPart::farthest(Vec3d direction, std::uint32_t start) const {
    std::uint32_t at = start;
    double height = dot(hull_.vertices[at], direction);
    for (bool climbs = true; climbs;) {
        climbs = false;
        std::uint32_t best = at;
        for (std::uint32_t i = first_[at]; i < first_[at + 1]; ++i) {
            const double other = dot(hull_.vertices[neighbours_[i]], direction);
            if (other > height) height = other, best = neighbours_[i], climbs = true;
        }
        at = best;
    }
    return at;
}

double sum_points(const ConvexPart& a, const ConvexPart& b) {
    if (takes_all_pairs(a, b)) return all_pairs(a, b);
    return points_a_corner * static_cast<double>(a.corners().size() + b.corners().size());
}

TriangleMesh convex_sum(const ConvexPart& a, const ConvexPart& b) {
    return takes_all_pairs(a, b) ? hull_of_all(a, b) : Sum(a, b).run();
}

}  // namespace cardioid::csg
