#include "csg/exact/boolean/flat_triangles.hpp"

#include <algorithm>
#include <map>

namespace cardioid::csg {

namespace {

using Triangle = std::array<std::uint32_t, 3>;
using Edge = std::pair<std::uint32_t, std::uint32_t>;

constexpr Triangle gone{};

/// Triangles by the directed edges they have.
class FlatTurner {
public:
    FlatTurner(const std::vector<ExactPoint>& points, std::vector<Triangle>& triangles)
        : points_(points), triangles_(triangles) {
        for (std::size_t t = 0; t < triangles_.size(); ++t) add(t);
    }

    [[nodiscard]] bool is_flat(const Triangle& t) const {
        return CGAL::collinear(points_[t[0]], points_[t[1]], points_[t[2]]);
    }

    /// Whether triangle t, which is flat, could be turned; the neighbour it was turned with is pushed on `changed`.
    bool turn(std::size_t t, std::vector<std::size_t>& changed) {
        const Triangle flat = triangles_[t];
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t a = flat[i], between = flat[(i + 1) % 3], c = flat[(i + 2) % 3];
            // The edge from c back to a, the corner opposite lying on it.
            if (!CGAL::collinear_are_strictly_ordered_along_line(points_[a], points_[between], points_[c])) continue;
            const auto beside = sides_.find({a, c});
            if (beside == sides_.end() || beside->second.size() != 1 || sides_[{c, a}].size() != 1) return false;
            const std::size_t other = beside->second[0];
            const std::uint32_t d = opposite(other, a, c);
            if (sides_.contains({between, d}) != sides_.contains({d, between})) return false;
            if (d != between && sides_.contains({between, d})) return false;
            remove(t), remove(other);
            if (d == between) {  // back to back: nothing is left of both
                triangles_[t] = triangles_[other] = gone;
                return true;
            }
            triangles_[t] = {a, between, d};
            triangles_[other] = {between, c, d};
            add(t), add(other);
            changed.push_back(t), changed.push_back(other);
            return true;
        }
        return false;
    }

private:
    [[nodiscard]] std::uint32_t opposite(std::size_t t, std::uint32_t a, std::uint32_t c) const {
        const Triangle& triangle = triangles_[t];
        return *std::ranges::find_if(triangle, [&](std::uint32_t v) { return v != a && v != c; });
    }
    void add(std::size_t t) {
        for (std::size_t i = 0; i < 3; ++i) sides_[{triangles_[t][i], triangles_[t][(i + 1) % 3]}].push_back(t);
    }
    void remove(std::size_t t) {
        for (std::size_t i = 0; i < 3; ++i) {
            const auto at = sides_.find({triangles_[t][i], triangles_[t][(i + 1) % 3]});
            std::erase(at->second, t);
            if (at->second.empty()) sides_.erase(at);
        }
    }

    const std::vector<ExactPoint>& points_;
    std::vector<Triangle>& triangles_;
    std::map<Edge, std::vector<std::size_t>> sides_;
};

}  // namespace

void turn_flat_triangles(const std::vector<ExactPoint>& points, std::vector<Triangle>& triangles) {
    std::vector<std::size_t> flat;
    for (std::size_t t = 0; t < triangles.size(); ++t)
        if (CGAL::collinear(points[triangles[t][0]], points[triangles[t][1]], points[triangles[t][2]]))
            flat.push_back(t);
    if (flat.empty()) return;
    FlatTurner turner(points, triangles);
    // A turn may leave a flat triangle along a shorter edge; each may wait for a neighbour, a bounded number of times.
    std::size_t turns_left = 64 * flat.size();
    for (std::size_t i = 0; i < flat.size() && turns_left > 0; ++i, --turns_left)
        if (triangles[flat[i]] != gone && turner.is_flat(triangles[flat[i]])) turner.turn(flat[i], flat);
    std::erase(triangles, gone);
}

}  // namespace cardioid::csg
