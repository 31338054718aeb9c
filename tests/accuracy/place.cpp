#include "tests/accuracy/place.hpp"

#include <array>
#include <numbers>

namespace cardioid::test {

namespace {

/// The wall of the box that r.x falls into, by area, and the point on it.
ProbePoint on_wall(Vec3d lo, Vec3d hi, Vec2d r) {
    const Vec3d size = hi - lo;
    const std::array<double, 3> area{size.y * size.z, size.z * size.x, size.x * size.y};
    double place = r.x * 2 * (area[0] + area[1] + area[2]);
    int wall = 0;
    while (wall < 5 && place >= area[static_cast<std::size_t>(wall / 2)])
        place -= area[static_cast<std::size_t>(wall++ / 2)];
    const int axis = wall / 2, s = (axis + 1) % 3, t = (axis + 2) % 3;
    ProbePoint made{lo, {}};
    made.p[axis] = wall % 2 == 0 ? lo[axis] : hi[axis];
    made.d[axis] = wall % 2 == 0 ? 1 : -1;
    made.p[s] += size[s] * place / area[static_cast<std::size_t>(axis)];
    made.p[t] += size[t] * r.y;
    return made;
}

}  // namespace

ProbePoint Place::at(Vec2d r) const {
    const double phi = 2 * std::numbers::pi * r.y;
    switch (kind) {
        case Kind::point:
            return {origin, along};
        case Kind::rectangle:
            return {origin + u * r.x + v * r.y, along};
        case Kind::disc: {
            const Frame frame{Vec3(normalize(along))};
            const double a = radius * std::sqrt(r.x);
            return {origin + Vec3d(frame.s) * (a * std::cos(phi)) + Vec3d(frame.t) * (a * std::sin(phi)), along};
        }
        case Kind::sphere: {
            const double z = 1 - 2 * r.x, a = std::sqrt(1 - z * z);
            const Vec3d n{a * std::cos(phi), a * std::sin(phi), z};
            return {origin + n * radius, n * side};
        }
        case Kind::room:
            return on_wall(origin, u, r);
        case Kind::view:
            return {along, origin + u * r.x + v * r.y - along};
    }
    return {};
}

}  // namespace cardioid::test
