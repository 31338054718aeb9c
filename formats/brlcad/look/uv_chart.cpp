#include "formats/brlcad/look/uv_chart.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace cardioid::formats::brlcad {

namespace {

constexpr double pi_d = std::numbers::pi;
/// A half space repeats itself after so much [mm].
constexpr double tile = 10000;

double turns(double y, double x) { return std::atan2(y, x) / (2 * pi_d); }

/// 0 at multiples of the tile's length, 1 in the middle between.
double there_and_back(double x) {
    const double whole = std::abs(x) / tile, part = whole - std::floor(whole);
    return part < 0.5 ? 2 * part : 2 * (1 - part);
}

}  // namespace

UvChart::UvChart(std::span<const double> numbers) {
    if (numbers.empty()) return;
    const auto kind = static_cast<Kind>(static_cast<int>(std::clamp(numbers[0], 0.0, 5.0)));
    const std::span<const double> n = numbers.subspan(1);
    const auto vector = [&](std::size_t i) { return Vec3d{n[i], n[i + 1], n[i + 2]}; };
    if (kind == Kind::faces && n.size() % 12 == 0) {
        for (std::size_t i = 0; i < n.size(); i += 12)
            faces_.push_back({vector(i), vector(i + 3), vector(i + 6), vector(i + 9)});
        kind_ = kind;
    } else if (kind == Kind::plane && n.size() == 9) {
        faces_.push_back({{}, vector(0), vector(3), vector(6)});
        kind_ = kind;
    } else if (kind != Kind::plane && kind != Kind::faces && n.size() >= (kind == Kind::tube ? 14U : 12U)) {
        to_local_ = {{vector(0), vector(3), vector(6)}, vector(9)};
        if (kind == Kind::tube) c_ = n[12], d_ = n[13];
        kind_ = kind;
    }
}

Vec2d UvChart::at(Vec3d p, Vec3 normal) const noexcept {
    const Vec3d q = to_local_.point(p);
    switch (kind_) {
        case Kind::none:
            break;
        case Kind::ball: {
            const double u = turns(q.y, q.x);
            return {u < 0 ? u + 1 : u, 2 * turns(q.z, std::hypot(q.x, q.y)) + 0.5};
        }
        case Kind::tube:
            return on_tube(q);
        case Kind::ring:
            return {turns(q.y, q.x) + 0.5, turns(q.z, std::hypot(q.x, q.y) - 1) + 0.5};
        case Kind::plane: {
            const Vec3d way = p - faces_[0].origin;
            return {there_and_back(dot(way, faces_[0].u)), there_and_back(dot(way, faces_[0].v))};
        }
        case Kind::faces:
            return on_faces(p, Vec3d(normal));
    }
    return {};
}

/// The side by its height, the ends by the distance from their middle. A point belongs to what it is nearest to.
Vec2d UvChart::on_tube(Vec3d q) const noexcept {
    const double height = std::clamp(q.z, 0.0, 1.0);
    const double a = 1 - height + c_ * height, b = 1 - height + d_ * height;
    const double x = a > 0 ? q.x / a : 0, y = b > 0 ? q.y / b : 0;
    const double u = turns(y, x) + 0.5, radius = std::min(std::hypot(x, y), 1.0);
    const double side = 1 - radius;
    if (1 - height < side && 1 - height < height) return {u, radius};
    if (height < side) return {u, 1 - radius};
    return {u, height};
}

Vec2d UvChart::on_faces(Vec3d p, Vec3d normal) const noexcept {
    const Face* best = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (const Face& face : faces_) {
        if (std::abs(dot(face.normal, normal)) < 0.9) continue;
        const double away = std::abs(dot(face.normal, p - face.origin));
        if (away < least) least = away, best = &face;
    }
    if (!best) return {};
    const Vec3d way = p - best->origin;
    return {std::abs(dot(way, best->u)), std::abs(1 - dot(way, best->v))};
}

}  // namespace cardioid::formats::brlcad
