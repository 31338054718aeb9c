#include "csg/shapes/profile_boolean.hpp"

#include <algorithm>
#include <cmath>

#include "csg/shapes/clipper_paths.hpp"

namespace cardioid::csg {

namespace {

/// Joins what follows the first part into one clip figure and applies `type` once.
ClipperLib::Paths against_rest(ClipperLib::ClipType type, std::span<const Profile> parts, double grid) {
    ClipperLib::Paths rest;
    for (const Profile& part : parts.subspan(1)) {
        const ClipperLib::Paths paths = sanitised(part, grid);
        rest.insert(rest.end(), paths.begin(), paths.end());
    }
    return combine(type, sanitised(parts[0], grid), rest);
}

ClipperLib::Paths intersection(std::span<const Profile> parts, double grid) {
    ClipperLib::Paths out = combine(ClipperLib::ctUnion, sanitised(parts[0], grid), {});
    for (const Profile& part : parts.subspan(1)) {
        if (out.empty()) break;
        out = combine(ClipperLib::ctIntersection, out, sanitised(part, grid));
    }
    return out;
}

}  // namespace

Profile profile_boolean(ProfileOp op, std::span<const Profile> parts, double grid) {
    if (parts.empty()) return {};
    const double step = usable_grid(parts, grid);
    const ClipperLib::Paths paths = op == ProfileOp::intersect  ? intersection(parts, step)
                                    : op == ProfileOp::subtract ? against_rest(ClipperLib::ctDifference, parts, step)
                                                                : against_rest(ClipperLib::ctUnion, parts, step);
    return to_profile(paths, step);
}

Profile transformed(const Profile& profile, const Affine& m) {
    const bool mirrors = m.row[0].x * m.row[1].y - m.row[0].y * m.row[1].x < 0;
    Profile out = profile;
    for (auto& contour : out.contours) {
        for (Vec2d& p : contour) {
            const Vec3d q = m.point({p.x, p.y, 0});
            p = {q.x, q.y};
        }
        if (mirrors) std::ranges::reverse(contour);
    }
    return out;
}

bool contains(const Profile& profile, Vec2d p) {
    bool inside = false;
    for (const auto& contour : profile.contours)
        for (std::size_t i = 0, j = contour.size() - 1; i < contour.size(); j = i++) {
            const Vec2d a = contour[j] - p, b = contour[i] - p;
            if ((a.y > 0) == (b.y > 0)) continue;
            // The edge meets the line through p along x to the right of p.
            if ((cross(a, b) > 0) == (b.y > a.y)) inside = !inside;
        }
    return inside;
}

}  // namespace cardioid::csg
