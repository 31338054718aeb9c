#include "csg/shapes/profile_offset.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "csg/exact/hull.hpp"
#include "csg/shapes/clipper_paths.hpp"
#include "rt_core/api/error.hpp"

namespace cardioid::csg {

namespace {

using ClipperLib::Path;
using ClipperLib::Paths;

/// Mitres are never cut off: OpenSCAD's limit.
constexpr double mitre_limit = 1e6;

/// A quarter of the range: two figures are added.
double grid_of(std::span<const Profile> parts, double grid) { return 4 * usable_grid(parts, grid / 4); }

Path moved(const Path& path, ClipperLib::IntPoint by) {
    Path out = path;
    for (ClipperLib::IntPoint& p : out) p.X += by.X, p.Y += by.Y;
    return out;
}

bool is_convex(const Path& path) {
    for (std::size_t i = 0; i < path.size(); ++i) {
        const ClipperLib::IntPoint a = path[i], b = path[(i + 1) % path.size()], c = path[(i + 2) % path.size()];
        const double turn = double(b.X - a.X) * double(c.Y - b.Y) - double(b.Y - a.Y) * double(c.X - b.X);
        if (turn < 0) return false;
    }
    return ClipperLib::Orientation(path);
}

/// The hull of points on the grid, counter-clockwise.
Path hull(const Path& points) {
    std::vector<Vec2d> plain;
    for (const ClipperLib::IntPoint p : points) plain.push_back({double(p.X), double(p.Y)});
    Path out;
    for (const Vec2d p : convex_hull(plain))
        out.emplace_back(static_cast<ClipperLib::cInt>(p.x), static_cast<ClipperLib::cInt>(p.y));
    return out;
}

/// What an edge sweeps over when it is moved along a closed contour: parallelograms, or one hull where it is convex.
void sweep_edge(const Path& edge, const Path& along, bool convex, Paths& out) {
    if (convex) {
        Path ends;
        for (const ClipperLib::IntPoint from : edge)
            for (const ClipperLib::IntPoint by : along) ends.emplace_back(from.X + by.X, from.Y + by.Y);
        out.push_back(hull(ends));
        return;
    }
    for (std::size_t j = 0; j < along.size(); ++j) {
        Path quad = moved(edge, along[j]);
        const Path far = moved(edge, along[(j + 1) % along.size()]);
        quad.insert(quad.end(), {far[1], far[0]});
        if (!ClipperLib::Orientation(quad)) ClipperLib::ReversePath(quad);
        out.push_back(std::move(quad));
    }
}

/// What the edges of one closed contour sweep over when they are moved along another.
void sweep(const Path& a, const Path& b, Paths& out) {
    const bool convex = is_convex(b);
    for (std::size_t i = 0; i < a.size(); ++i) sweep_edge({a[i], a[(i + 1) % a.size()]}, b, convex, out);
}

/// All of a, moved to a point of each part of b.
void fill_insides(const Paths& a, const Paths& b, Paths& out) {
    for (const Path& part : b)
        if (ClipperLib::Orientation(part))
            for (const Path& contour : a) out.push_back(moved(contour, part[0]));
}

}  // namespace

Profile profile_offset(const Profile& profile, double distance, Corner corner, double arc_corners, double grid) {
    const double reach = std::abs(distance);
    const Profile corners{{{{reach, reach}, {-reach, -reach}}}};
    const double step = grid_of(std::array{profile, corners}, grid);
    const double sagitta = reach * (1 - std::cos(std::numbers::pi / arc_corners));
    ClipperLib::ClipperOffset offset(corner == Corner::mitre ? mitre_limit : 2.0,
                                     corner == Corner::round ? sagitta / step : 1.0);
    const ClipperLib::JoinType join = corner == Corner::mitre   ? ClipperLib::jtMiter
                                      : corner == Corner::round ? ClipperLib::jtRound
                                                                : ClipperLib::jtSquare;
    offset.AddPaths(sanitised(profile, step), join, ClipperLib::etClosedPolygon);
    Paths out;
    offset.Execute(out, distance / step);
    if (out.empty()) return {};
    return to_profile(combine(ClipperLib::ctUnion, out, {}), step);
}

Profile profile_minkowski(const Profile& a, const Profile& b, double grid) {
    const double step = grid_of(std::array{a, b}, grid);
    const Paths first = sanitised(a, step), second = sanitised(b, step);
    Paths swept;
    for (const Path& one : first)
        for (const Path& other : second) is_convex(other) ? sweep(one, other, swept) : sweep(other, one, swept);
    fill_insides(first, second, swept);
    fill_insides(second, first, swept);
    if (swept.empty()) return {};
    return to_profile(combine(ClipperLib::ctUnion, swept, {}), step);
}

Profile widened_line(const std::vector<Vec2d>& points, double width, LineEnd end) {
    constexpr double step = 1e-4, farthest = 1e11;
    Path line;
    for (const Vec2d p : points)
        if (!(std::abs(p.x) <= farthest && std::abs(p.y) <= farthest && std::abs(width) <= farthest))
            throw Error(ErrorCode::bad_input, "a line reaches beyond 1e11, wanted one that does not");
    for (const Vec2d p : points)
        line.emplace_back(static_cast<ClipperLib::cInt>(p.x / step), static_cast<ClipperLib::cInt>(p.y / step));
    ClipperLib::ClipperOffset offset;
    offset.AddPath(line, ClipperLib::jtMiter,
                   end == LineEnd::butt     ? ClipperLib::etOpenButt
                   : end == LineEnd::square ? ClipperLib::etOpenSquare
                                            : ClipperLib::etOpenRound);
    Paths out;
    offset.Execute(out, width / 2 / step);
    return to_profile(out, step);
}

Profile by_winding(const Profile& profile, double grid) {
    const double step = usable_grid(std::array{profile}, grid);
    Paths paths;
    for (const auto& contour : profile.contours) {
        Path& path = paths.emplace_back();
        for (const Vec2d p : contour)
            path.emplace_back(static_cast<ClipperLib::cInt>(p.x / step), static_cast<ClipperLib::cInt>(p.y / step));
    }
    if (paths.empty()) return {};
    return to_profile(combine(ClipperLib::ctUnion, paths, {}), step);
}

Profile without_holes(const Profile& profile, double grid) {
    const double step = usable_grid(std::array{profile}, grid);
    Paths outer;
    for (Path& path : sanitised(profile, step))
        if (ClipperLib::Orientation(path)) outer.push_back(std::move(path));
    if (outer.empty()) return {};
    return to_profile(combine(ClipperLib::ctUnion, outer, {}), step);
}

}  // namespace cardioid::csg
