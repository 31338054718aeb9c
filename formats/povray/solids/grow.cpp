#include "formats/povray/solids/bounds.hpp"
#include "formats/povray/solids/shapes.hpp"

namespace cardioid::formats::povray {

namespace {

/// Moves the ends lo and hi of an axis outwards by the shares of `by`, all of them local.
struct Axis {
    double lo, hi;
    Axis(double from, double to, Vec2d shares, double by) : lo(from - shares.x * by), hi(to + shares.y * by) {}
};

/// The map that carries the box `from` to the box `to`, axis by axis; an axis without length stays.
Affine box_to_box(const Box3d& from, const Box3d& to) {
    Affine map;
    for (int i = 0; i < 3; ++i) {
        const double length = from.hi[i] - from.lo[i];
        const double times = length > 0 ? (to.hi[i] - to.lo[i]) / length : 1;
        map.row[static_cast<std::size_t>(i)] = {};
        map.row[static_cast<std::size_t>(i)][i] = times;
        map.t[i] = to.lo[i] - from.lo[i] * times;
    }
    return map;
}

}  // namespace

Leaf grown(const Leaf& leaf, const SolidTree& solids, double scale, const Growth& growth) {
    Leaf out = leaf;
    const Affine& m = leaf.to_world;
    if (leaf.kind == LeafKind::half_space) {
        const Vec3d outwards = normalize(cross(m.column(0), m.column(1)) * (m.determinant() > 0 ? 1.0 : -1.0));
        out.to_world.t += outwards * (growth.by / scale);
        return out;
    }
    const Box3d box = local_box(leaf, solids);
    const double by = growth.by / scale, around = growth.around ? 1.0 : 0.0;
    const auto local = [&](int axis) { return by / length(m.column(axis)); };
    const Axis x(box.lo.x, box.hi.x, growth.x + Vec2d{around, around}, local(0));
    const Axis y(box.lo.y, box.hi.y, growth.y + Vec2d{around, around}, local(1));
    const bool upright = leaf.kind == LeafKind::cone || leaf.kind == LeafKind::prism;
    const Axis z(box.lo.z, box.hi.z, upright ? growth.z : growth.z + Vec2d{around, around}, local(2));
    out.to_world = m * box_to_box(box, {{x.lo, y.lo, z.lo}, {x.hi, y.hi, z.hi}});
    return out;
}

}  // namespace cardioid::formats::povray
