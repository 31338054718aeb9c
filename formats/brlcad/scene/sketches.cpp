#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "csg/shapes/profile_boolean.hpp"
#include "formats/brlcad/scene/solids.hpp"

namespace cardioid::formats::brlcad {

namespace {

constexpr double pi_d = std::numbers::pi;
/// Chords in place of a whole circle, and of a Bezier curve or a NURB's stretch: areas are right to 4e-6.
constexpr double circle_steps = 1440;
constexpr int bezier_steps = 256;
/// Of a NURB's corners that one place of it depends on.
constexpr std::size_t most_order = 64;

using Node = std::optional<std::uint32_t>;
using Path = std::vector<Vec2d>;

Vec2d corner(const Solid& sketch, std::uint32_t i) { return {sketch.numbers[9 + 2 * i], sketch.numbers[10 + 2 * i]}; }

/// From a to b around the centre, the way the arc goes.
Path arc_path(Vec2d centre, Vec2d a, Vec2d b, bool clockwise, bool whole) {
    const double radius = std::hypot(a.x - centre.x, a.y - centre.y);
    const double from = std::atan2(a.y - centre.y, a.x - centre.x);
    double sweep = std::atan2(b.y - centre.y, b.x - centre.x) - from;
    if (clockwise && sweep >= 0) sweep -= 2 * pi_d;
    if (!clockwise && sweep <= 0) sweep += 2 * pi_d;
    if (whole) sweep = 2 * pi_d;
    const int steps = std::max(2, static_cast<int>(std::ceil(std::abs(sweep) / (2 * pi_d) * circle_steps)));
    Path out{a};
    for (int i = 1; i < steps; ++i) {
        const double angle = from + sweep * i / steps;
        out.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
    }
    out.push_back(whole ? a : b);
    return out;
}

Path arc(const Solid& sketch, const SketchCurve& curve) {
    const Vec2d a = corner(sketch, curve.corners[0]), b = corner(sketch, curve.corners[1]);
    if (curve.radius < 0) return arc_path(b, a, a, false, true);
    const Vec2d chord{b.x - a.x, b.y - a.y};
    const double size = std::hypot(chord.x, chord.y);
    if (!(size > 0)) return {};
    const double away = std::sqrt(std::max(0.0, curve.radius * curve.radius - size * size / 4)) / size;
    const double side = curve.centre_left ? away : -away;
    return arc_path({a.x + chord.x / 2 - chord.y * side, a.y + chord.y / 2 + chord.x * side}, a, b, curve.clockwise,
                    false);
}

/// By de Casteljau's corner cutting.
Path bezier(const Solid& sketch, const SketchCurve& curve) {
    Path out;
    for (int step = 0; step <= bezier_steps; ++step) {
        const double t = static_cast<double>(step) / bezier_steps;
        Path p;
        for (const std::uint32_t i : curve.corners) p.push_back(corner(sketch, i));
        for (; p.size() > 1; p.pop_back())
            for (std::size_t i = 0; i + 1 < p.size(); ++i)
                p[i] = {p[i].x * (1 - t) + p[i + 1].x * t, p[i].y * (1 - t) + p[i + 1].y * t};
        out.push_back(p[0]);
    }
    out.back() = corner(sketch, curve.corners.back());
    return out;
}

bool is_nurb(const SketchCurve& curve) {
    const std::size_t points = curve.corners.size(), knots = curve.knots.size();
    return points >= 2 && knots >= points + 2 && knots <= points + std::min(points, most_order) &&
           std::is_sorted(curve.knots.begin(), curve.knots.end()) &&
           (curve.weights.empty() || curve.weights.size() == points) &&
           std::all_of(curve.weights.begin(), curve.weights.end(), [](double w) { return w > 0; }) &&
           curve.knots[knots - points - 1] < curve.knots[points];
}

/// By de Boor's corner cutting of (w x, w y, w), in as many chords to each stretch between knots.
Path nurb(const Solid& sketch, const SketchCurve& curve) {
    const std::size_t points = curve.corners.size(), degree = curve.knots.size() - points - 1;
    const auto& k = curve.knots;
    Path out;
    for (std::size_t span = degree; span < points; ++span) {
        if (!(k[span] < k[span + 1])) continue;
        for (int step = out.empty() ? 0 : 1; step <= bezier_steps; ++step) {
            const double t = k[span] + (k[span + 1] - k[span]) * step / bezier_steps;
            std::vector<Vec3d> p;
            for (std::size_t i = span - degree; i <= span; ++i) {
                const Vec2d c = corner(sketch, curve.corners[i]);
                const double w = curve.weights.empty() ? 1 : curve.weights[i];
                p.push_back({c.x * w, c.y * w, w});
            }
            for (std::size_t r = 1; r <= degree; ++r)
                for (std::size_t j = degree; j >= r; --j) {
                    const std::size_t i = span - degree + j;
                    const double share = (t - k[i]) / (k[i + degree + 1 - r] - k[i]);
                    p[j] = p[j - 1] * (1 - share) + p[j] * share;
                }
            out.push_back({p[degree].x / p[degree].z, p[degree].y / p[degree].z});
        }
    }
    // A clamped curve ends at its corners, whatever rounding says.
    if (k[0] == k[degree]) out.front() = corner(sketch, curve.corners.front());
    if (k[points] == k.back()) out.back() = corner(sketch, curve.corners.back());
    return out;
}

Path path_of(const Solid& sketch, const SketchCurve& curve) {
    if (curve.kind == SketchCurve::Kind::nurb) return is_nurb(curve) ? nurb(sketch, curve) : Path{};
    if (curve.kind == SketchCurve::Kind::arc) return arc(sketch, curve);
    if (curve.kind == SketchCurve::Kind::bezier) return bezier(sketch, curve);
    return {corner(sketch, curve.corners[0]), corner(sketch, curve.corners[1])};
}

double area_of(const Path& p) {
    double twice = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const Vec2d a = p[i], b = p[(i + 1) % p.size()];
        twice += a.x * b.y - a.y * b.x;
    }
    return twice / 2;
}

/// Paths joined at their ends into closed ones; false where one stays open.
bool close(std::vector<Path> paths, std::vector<Path>& out) {
    const auto same = [](Vec2d a, Vec2d b) { return a.x == b.x && a.y == b.y; };
    while (!paths.empty()) {
        Path loop = std::move(paths.back());
        paths.pop_back();
        while (!same(loop.front(), loop.back())) {
            const auto next = std::find_if(paths.begin(), paths.end(), [&](const Path& p) {
                return same(p.front(), loop.back()) || same(p.back(), loop.back());
            });
            if (next == paths.end()) return false;
            if (!same(next->front(), loop.back())) std::reverse(next->begin(), next->end());
            loop.insert(loop.end(), next->begin() + 1, next->end());
            paths.erase(next);
        }
        loop.pop_back();
        if (loop.size() > 2) out.push_back(std::move(loop));
    }
    return true;
}

/// Outer outlines counter-clockwise, holes clockwise: by how many others hold each.
void orient(Profile& profile) {
    for (std::size_t i = 0; i < profile.contours.size(); ++i) {
        Profile others = profile;
        const Vec2d at = profile.contours[i][0];
        others.contours.erase(others.contours.begin() + static_cast<std::ptrdiff_t>(i));
        const bool hole = csg::contains(others, at);
        if ((area_of(profile.contours[i]) < 0) != hole)
            std::reverse(profile.contours[i].begin(), profile.contours[i].end());
    }
}

/// The figure of the sketch that a solid names; nothing, with a note, where there is none.
std::optional<Profile> figure(SolidTarget& target, const Solid& solid) {
    const Object* object = target.database ? target.database->find(solid.sketch) : nullptr;
    if (!object || object->solid.kind != SolidKind::sketch) {
        target.note = "is of sketch \"" + solid.sketch + "\", which " +
                      (object ? "is no sketch that can be read" : "is not there") + ", and is left out";
        return std::nullopt;
    }
    std::vector<Path> paths;
    for (const double x : object->solid.numbers)
        if (!std::isfinite(x)) return std::nullopt;
    for (const SketchCurve& curve : object->solid.curves)
        if (Path path = path_of(object->solid, curve); path.size() > 1) paths.push_back(std::move(path));
    Profile out;
    if (!close(std::move(paths), out.contours)) {
        target.note = "is of sketch \"" + solid.sketch + "\", whose outline is not closed, and is left out";
        return std::nullopt;
    }
    orient(out);
    if (out.empty()) target.note = "has no volume";
    return out.empty() ? std::optional<Profile>{} : out;
}

Vec3d vector(const Solid& solid, std::size_t i) {
    return {solid.numbers[i], solid.numbers[i + 1], solid.numbers[i + 2]};
}

}  // namespace

std::optional<std::uint32_t> add_extrude(SolidTarget& target, const Solid& solid) {
    std::optional<Profile> profile = figure(target, solid);
    if (!profile) return std::nullopt;
    return add_leaf(target,
                    {.kind = LeafKind::prism,
                     .to_world = columns(vector(solid, 6), vector(solid, 9), vector(solid, 3), vector(solid, 0)),
                     .a = 1,
                     .data = target.tree.add_profile(std::move(*profile))});
}

std::optional<std::uint32_t> add_revolve(SolidTarget& target, const Solid& solid) {
    std::optional<Profile> profile = figure(target, solid);
    if (!profile) return std::nullopt;
    for (const auto& contour : profile->contours)
        for (const Vec2d p : contour)
            if (p.x < 0) {
                target.note = "is of a sketch that reaches over the axis, and is left out";
                return std::nullopt;
            }
    const Vec3d origin = vector(solid, 0), axis = vector(solid, 3), start = vector(solid, 6);
    const Vec3d z = axis * (1 / length(axis)), out = start - z * dot(start, z), x = out * (1 / length(out));
    const Affine frame = columns(x, cross(z, x), z, origin);
    const Node whole = add_leaf(
        target,
        {.kind = LeafKind::revolution, .to_world = frame, .data = target.tree.add_profile(std::move(*profile))});
    const double angle = solid.numbers[9];
    if (!whole || !(angle > 0 && angle < 2 * pi_d)) return whole;
    const Node first =
        add_leaf(target, {.kind = LeafKind::half_space, .to_world = upright(frame.vector({0, -1, 0}), origin)});
    const Node last =
        add_leaf(target, {.kind = LeafKind::half_space,
                          .to_world = upright(frame.vector({-std::sin(angle), std::cos(angle), 0}), origin)});
    if (!first || !last) return std::nullopt;
    const SolidOp op = angle <= pi_d ? SolidOp::intersect : SolidOp::unite;
    return target.tree.add_node(SolidOp::intersect, {*whole, target.tree.add_node(op, {*first, *last})});
}

}  // namespace cardioid::formats::brlcad
