#include <algorithm>
#include <cmath>
#include <limits>

#include "csg/leaves/solvers.hpp"
#include "csg/shapes/profile_boolean.hpp"

namespace cardioid::csg {
namespace {

/// A place where the line may cross the surface; whether it does is decided by what lies on both sides of it.
struct Candidate {
    double t;
    std::uint32_t face;
};

thread_local std::vector<Candidate> candidates;

/// Turns candidates into events: the line is inside between two of them where its middle is.
/// So the number of events is even whatever rounding did to the candidates.
template <class Inside>
void append_crossings(std::uint32_t index, const Inside& inside, EventList& out) {
    std::sort(candidates.begin(), candidates.end(),
              [](const Candidate& x, const Candidate& y) { return x.t < y.t || (x.t == y.t && x.face < y.face); });
    bool was_inside = false;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        const bool last = i + 1 == candidates.size();
        if (!last && candidates[i + 1].t == candidates[i].t) continue;
        const bool is_inside = !last && inside(0.5 * (candidates[i].t + candidates[i + 1].t));
        if (is_inside != was_inside) out.push_back(make_event(candidates[i].t, index, candidates[i].face, is_inside));
        was_inside = is_inside;
    }
}

/// Calls visit(a, b, number) for every edge of every contour.
template <class Visit>
void each_edge(const Profile& profile, const Visit& visit) {
    std::uint32_t number = 0;
    for (const auto& contour : profile.contours)
        for (std::size_t i = 0; i < contour.size(); ++i)
            visit(contour[i], contour[i + 1 == contour.size() ? 0 : i + 1], number++);
}

/// The edge of that number; contours are short enough to walk.
std::pair<Vec2d, Vec2d> edge(const Profile& profile, std::uint32_t number) {
    for (const auto& contour : profile.contours) {
        if (number < contour.size()) return {contour[number], contour[number + 1 == contour.size() ? 0 : number + 1]};
        number -= static_cast<std::uint32_t>(contour.size());
    }
    return {};
}

constexpr std::uint32_t bottom_face = 0x40000000U, top_face = 0x40000001U;

/// Side plane of the edge a-b of a prism whose top is the profile times `scale`; outside is to the right of the edge.
Plane side_plane(Vec2d a, Vec2d b, double scale) {
    const Vec2d e = b - a;
    const double offset = e.y * a.x - e.x * a.y;  // at z = 0; scale times that at z = 1
    return {{e.y, -e.x, -(scale - 1) * offset}, offset};
}

}  // namespace

std::vector<Plane> convex_prism_planes(const Profile& profile, double top_scale, std::size_t limit) {
    if (profile.contours.size() != 1 || profile.contours[0].size() > limit) return {};
    const auto& c = profile.contours[0];
    double turned = 0;  // a convex contour turns left all the way, once around
    for (std::size_t i = 0; i < c.size(); ++i) {
        const Vec2d e = c[(i + 1) % c.size()] - c[i], next = c[(i + 2) % c.size()] - c[(i + 1) % c.size()];
        if (!(cross(e, next) > 0)) return {};
        turned += std::atan2(cross(e, next), dot(e, next));
    }
    if (turned > 7) return {};
    std::vector<Plane> planes;
    each_edge(profile, [&](Vec2d a, Vec2d b, std::uint32_t) { planes.push_back(side_plane(a, b, top_scale)); });
    planes.push_back({{0, 0, -1}, 0});
    planes.push_back({{0, 0, 1}, 1});
    return planes;
}

void append_prism(const SolvedLeaf& leaf, std::uint32_t index, Vec3d o, Vec3d d, EventList& out) {
    const Span slab = axis_box_span({-HUGE_VAL, -HUGE_VAL, 0}, {HUGE_VAL, HUGE_VAL, 1}, o, d);
    if (slab.empty()) return;
    const Profile& profile = *leaf.shape->profile;
    candidates.clear();
    if (std::isfinite(slab.t0))
        candidates = {{slab.t0, slab.face0 == 4 ? bottom_face : top_face},
                      {slab.t1, slab.face1 == 4 ? bottom_face : top_face}};
    each_edge(profile, [&](Vec2d a, Vec2d b, std::uint32_t number) {
        const Plane side = side_plane(a, b, leaf.a);
        const double nd = dot(side.n, d);
        const double t = (side.d - dot(side.n, o)) / nd;
        if (nd == 0 || !(t > slab.t0 && t < slab.t1)) return;
        const double scale = 1 + (leaf.a - 1) * (o.z + t * d.z);
        const Vec2d e = b - a, at = Vec2d{o.x + t * d.x, o.y + t * d.y} * (1 / scale) - a;
        const double along = dot(at, e) / dot(e, e);
        if (along >= -1e-9 && along <= 1 + 1e-9) candidates.push_back({t, number});
    });
    append_crossings(
        index,
        [&](double t) {
            const double scale = 1 + (leaf.a - 1) * (o.z + t * d.z);
            return contains(profile, Vec2d{o.x + t * d.x, o.y + t * d.y} * (1 / scale));
        },
        out);
}

Vec3d prism_normal(const SolvedLeaf& leaf, std::uint32_t face) {
    if (face >= bottom_face) return {0, 0, face == top_face ? 1.0 : -1.0};
    const auto [a, b] = edge(*leaf.shape->profile, face);
    return side_plane(a, b, leaf.a).n;
}

void append_revolution(const SolvedLeaf& leaf, std::uint32_t index, Vec3d o, Vec3d d, EventList& out) {
    const Profile& profile = *leaf.shape->profile;
    const double middle = -(o.x * d.x + o.y * d.y + o.z * d.z) / dot(d, d);
    const Vec3d p = o + d * middle;
    candidates.clear();
    each_edge(profile, [&](Vec2d a, Vec2d b, std::uint32_t number) {
        const double lo = std::min(a.y, b.y), hi = std::max(a.y, b.y);
        if (lo == hi) {
            if (d.z != 0) candidates.push_back({middle + (lo - p.z) / d.z, number});
            return;
        }
        // The line x = a.x + m (z - a.y) turned about z: x^2 + y^2 = that squared.
        const double m = (b.x - a.x) / (b.y - a.y), radius = a.x + m * (p.z - a.y), dr = m * d.z;
        const double qa = d.x * d.x + d.y * d.y - dr * dr;
        const double qb = p.x * d.x + p.y * d.y - radius * dr;
        const double qc = p.x * p.x + p.y * p.y - radius * radius;
        const auto add = [&](double s) {
            const double z = p.z + s * d.z, slack = 1e-9 * (hi - lo);
            if (z >= lo - slack && z <= hi + slack && radius + s * dr >= -slack)
                candidates.push_back({middle + s, number});
        };
        if (std::abs(qa) <= 1e-14 * (d.x * d.x + d.y * d.y + dr * dr)) {
            if (qb != 0) add(-qc / (2 * qb));
            return;
        }
        const double discriminant = qb * qb - qa * qc;
        if (discriminant < 0) return;
        const double q = -(qb + std::copysign(std::sqrt(discriminant), qb));
        add(q / qa);
        if (q != 0) add(qc / q);
    });
    append_crossings(
        index,
        [&](double t) {
            const double x = o.x + t * d.x, y = o.y + t * d.y;
            return contains(profile, {std::sqrt(x * x + y * y), o.z + t * d.z});
        },
        out);
}

Vec3d revolution_normal(const SolvedLeaf& leaf, std::uint32_t face, Vec3d p) {
    const auto [a, b] = edge(*leaf.shape->profile, face);
    const Vec2d e = b - a;
    const double rho = std::sqrt(p.x * p.x + p.y * p.y);
    const Vec2d radial = rho > 0 ? Vec2d{p.x / rho, p.y / rho} : Vec2d{0, 0};
    return {e.y * radial.x, e.y * radial.y, -e.x};
}

}  // namespace cardioid::csg
