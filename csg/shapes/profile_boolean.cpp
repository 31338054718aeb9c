#include "csg/shapes/profile_boolean.hpp"

#include <algorithm>
#include <cmath>
#include <polyclipping/clipper.hpp>

#include "rt_core/api/error.hpp"

namespace cardioid::csg {

namespace {

/// Grid steps a coordinate may have: Clipper computes slopes in double, so further bits would be lost there.
constexpr double most_steps = 0x1p50;

bool is_finite(const std::vector<Vec2d>& contour) {
    return std::ranges::all_of(contour, [](Vec2d p) { return std::isfinite(p.x) && std::isfinite(p.y); });
}

/// The largest power of two that is at most `grid`, doubled until the figures fit into Clipper's range.
double usable_grid(std::span<const Profile> parts, double grid) {
    double largest = 0;
    for (const Profile& part : parts)
        for (const auto& contour : part.contours)
            if (is_finite(contour))
                for (const Vec2d p : contour) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
    int exponent = 0, least = 0;
    static_cast<void>(std::frexp(grid > 0 ? grid : 0x1p-16, &exponent));
    static_cast<void>(std::frexp(largest / most_steps, &least));
    return std::ldexp(1.0, largest > 0 ? std::max(exponent - 1, least) : exponent - 1);
}

/// Clipper fails without edges, too; the caller leaves those out.
void execute(ClipperLib::Clipper& clipper, ClipperLib::ClipType type, ClipperLib::Paths& out,
             ClipperLib::PolyFillType fill) {
    try {
        if (clipper.Execute(type, out, fill, fill)) return;
    } catch (const ClipperLib::clipperException&) {  // no more is known than that it failed
    }
    throw Error(ErrorCode::bad_input, "a boolean of plane figures failed: their contours are too tangled for Clipper");
}

/// The figure on the grid, regularised by the even-odd rule: outer contours counter-clockwise, holes clockwise.
ClipperLib::Paths sanitised(const Profile& profile, double grid) {
    ClipperLib::Clipper clipper;
    bool has_edges = false;
    for (const auto& contour : profile.contours) {
        if (!is_finite(contour)) continue;
        ClipperLib::Path path;
        path.reserve(contour.size());
        for (const Vec2d p : contour)
            path.emplace_back(static_cast<ClipperLib::cInt>(p.x / grid), static_cast<ClipperLib::cInt>(p.y / grid));
        has_edges |= clipper.AddPath(path, ClipperLib::ptSubject, true);
    }
    ClipperLib::Paths out;
    if (has_edges) execute(clipper, ClipperLib::ctUnion, out, ClipperLib::pftEvenOdd);
    return out;
}

ClipperLib::Paths combine(ClipperLib::ClipType type, const ClipperLib::Paths& subject, const ClipperLib::Paths& clip) {
    ClipperLib::Clipper clipper;
    clipper.StrictlySimple(true);  // contours may touch themselves in corners only, as extrusions want
    bool has_edges = clipper.AddPaths(subject, ClipperLib::ptSubject, true);
    has_edges |= clipper.AddPaths(clip, ClipperLib::ptClip, true);
    ClipperLib::Paths out;
    if (has_edges) execute(clipper, type, out, ClipperLib::pftNonZero);
    return out;
}

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
    Profile out;
    out.contours.reserve(paths.size());
    for (const ClipperLib::Path& path : paths) {
        std::vector<Vec2d> contour;
        contour.reserve(path.size());
        for (const ClipperLib::IntPoint p : path)
            contour.push_back({static_cast<double>(p.X) * step, static_cast<double>(p.Y) * step});
        if (contour.size() >= 3) out.contours.push_back(std::move(contour));
    }
    return out;
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
