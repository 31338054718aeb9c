#include "photon/map/hull.hpp"

#include <algorithm>
#include <limits>

namespace cardioid::photon {

namespace {

float turn(Vec2 a, Vec2 b, Vec2 c) { return cross(b - a, c - a); }

}  // namespace

float Hull::outside(Vec2 q) const noexcept {
    float most = -std::numeric_limits<float>::infinity();
    if (corners.size() < 3) return -most;
    Vec2 from = corners.back().p();
    for (const PlanePoint& to : corners) {
        most = std::max(most, -turn(from, to.p(), q) / length(to.p() - from));
        from = to.p();
    }
    return most;
}

Hull convex_hull(std::span<PlanePoint> points, std::span<PlanePoint> room) noexcept {
    std::ranges::sort(points, [](const PlanePoint& a, const PlanePoint& b) {
        return a.x < b.x || (a.x == b.x && (a.y < b.y || (a.y == b.y && a.index < b.index)));
    });
    std::size_t n = 0;
    // One chain from the left to the right below, then, past `least` corners, one back above.
    const auto extend = [&](const PlanePoint& point, std::size_t least) {
        while (n >= least + 2 && turn(room[n - 2].p(), room[n - 1].p(), point.p()) <= 0) --n;
        if (n == 0 || room[n - 1].p() != point.p()) room[n++] = point;
    };
    for (const PlanePoint& point : points) extend(point, 0);
    const std::size_t below = n == 0 ? 0 : n - 1;
    for (std::size_t i = points.size(); i-- > 0;) extend(points[i], below);
    if (n > 1) --n;  // the first corner came again
    Hull hull{room.first(n)};
    for (std::size_t i = 1; i + 1 < n; ++i) hull.area += turn(room[0].p(), room[i].p(), room[i + 1].p()) / 2;
    return hull;
}

}  // namespace cardioid::photon
