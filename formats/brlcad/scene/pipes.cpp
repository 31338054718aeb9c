#include <algorithm>
#include <cmath>

#include "formats/brlcad/scene/solids.hpp"

namespace cardioid::formats::brlcad {

namespace {

/// Sine of the angle below which a point of a pipe is no bend.
constexpr double straight = 1e-6;

struct PipePoint {
    Vec3d p;
    double inner, outer, bend;  ///< radii
    Vec3d in{}, out{};          ///< where the straight parts before and after end
};

/// Half of a pipe: its outside or its bore.
class PipeMaker {
public:
    PipeMaker(SolidTarget& target, std::vector<PipePoint> points, double PipePoint::*radius)
        : target_(target), points_(std::move(points)), radius_(radius) {}

    std::vector<std::uint32_t> run() {
        for (PipePoint& point : points_) point.in = point.out = point.p;
        for (std::size_t i = 1; i + 1 < points_.size(); ++i) bend(i);
        for (std::size_t i = 0; i + 1 < points_.size(); ++i) tube(points_[i], points_[i + 1]);
        return std::move(parts_);
    }

private:
    void keep(std::optional<std::uint32_t> part) {
        if (part) parts_.push_back(*part);
    }

    void tube(const PipePoint& a, const PipePoint& b) {
        const Vec3d axis = b.in - a.out;
        const double r0 = a.*radius_, r1 = b.*radius_;
        if (!(length(axis) > 0) || !(r0 > 0 || r1 > 0)) return;
        Affine map = upright(axis, a.out);
        for (Vec3d& row : map.row) row.z *= length(axis);
        keep(add_leaf(target_, {.kind = LeafKind::cone, .to_world = map, .a = r0, .b = r1}));
    }

    /// A sector of a torus that touches both straight parts.
    void bend(std::size_t i) {
        PipePoint& at = points_[i];
        const Vec3d to_last = points_[i - 1].p - at.p, to_next = points_[i + 1].p - at.p;
        if (!(length(to_last) > 0 && length(to_next) > 0)) return;
        const Vec3d u = normalize(to_last), v = normalize(to_next), axis = cross(u, v);
        const double sine = length(axis);
        if (sine < straight) return;
        // Half the angle between the parts, from its own sine and cosine.
        const double half = std::atan2(sine, dot(u, v)) / 2;
        const Vec3d centre = at.p + normalize(u + v) * (at.bend / std::sin(half));
        at.in = at.p + u * (at.bend / std::tan(half));
        at.out = at.p + v * (at.bend / std::tan(half));
        const double r = at.*radius_;
        if (!(r > 0 && at.bend > r)) return;
        const auto ring =
            add_leaf(target_, {.kind = LeafKind::torus, .to_world = upright(axis, centre), .a = at.bend, .b = r});
        const auto before = add_leaf(target_, {.kind = LeafKind::half_space, .to_world = upright(u, at.in)});
        const auto after = add_leaf(target_, {.kind = LeafKind::half_space, .to_world = upright(v, at.out)});
        if (ring && before && after)
            parts_.push_back(target_.tree.add_node(SolidOp::intersect, {*ring, *before, *after}));
    }

    SolidTarget& target_;
    std::vector<PipePoint> points_;
    double PipePoint::*radius_;
    std::vector<std::uint32_t> parts_;
};

}  // namespace

std::optional<std::uint32_t> add_pipe(SolidTarget& target, const Solid& solid) {
    std::vector<PipePoint> points;
    const auto& v = solid.numbers;
    for (std::size_t i = 0; i + 5 < v.size(); i += 6)
        points.push_back({{v[i], v[i + 1], v[i + 2]}, v[i + 3] / 2, v[i + 4] / 2, v[i + 5]});
    const auto outside = PipeMaker(target, points, &PipePoint::outer).run();
    if (outside.empty()) {
        target.note = "has no volume";
        return std::nullopt;
    }
    target.note.clear();  // a joint without length is none
    const std::uint32_t whole = target.tree.add_node(SolidOp::unite, outside);
    std::vector<std::uint32_t> cut{whole};
    const auto bore = PipeMaker(target, points, &PipePoint::inner).run();
    cut.insert(cut.end(), bore.begin(), bore.end());
    return bore.empty() ? whole : target.tree.add_node(SolidOp::subtract, cut);
}

}  // namespace cardioid::formats::brlcad
