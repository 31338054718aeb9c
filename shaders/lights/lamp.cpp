#include "shaders/lights/lamp.hpp"

#include <algorithm>
#include <cmath>

namespace cardioid::shaders {
namespace {

/// Matrices of .csg files have six digits, so that rotations are off by some 1e-6.
constexpr double roundness = 1e-4;

Rgb read_radiance(const Params& params, double area) {
    if (!params.has("power")) return params.colour("radiance", Rgb(1));
    if (params.has("radiance")) params.wrong("power", "left out where radiance is given");
    const Rgb power = params.colour("power", {});
    const double per_radiance = std::numbers::pi * area;
    const auto channel = [&](float phi) { return static_cast<float>(double{phi} / per_radiance); };
    const Rgb radiance{channel(power.r), channel(power.g), channel(power.b)};
    if (!is_finite(radiance)) params.wrong("power", "smaller for so small a lamp");
    return radiance;
}

[[noreturn]] void refuse_transform(const Params& params, const std::string& why) {
    throw Error(ErrorCode::bad_input, params.where() + ": the transform around this light " + why);
}

}  // namespace

Lamp::Lamp(const Params& params, const LampShape& shape, double area)
    : shape_(shape),
      area_(area),
      radiance_(read_radiance(params, area)),
      visible_(params.boolean("visible", true)),
      grid_(read_grid(params)) {}

Rgb Lamp::power() const noexcept { return radiance_ * static_cast<float>(std::numbers::pi * area_); }

std::optional<LampShape> Lamp::shape() const noexcept {
    return visible_ ? std::optional<LampShape>(shape_) : std::nullopt;
}

LightEmission Lamp::leave(Vec3d o, Vec3d normal, Vec2 u_direction) const noexcept {
    return leave_along(o, normal, Frame(Vec3(normal)).to_world(sample_cosine_hemisphere(u_direction)));
}

LightEmission Lamp::leave_along(Vec3d o, Vec3d normal, Vec3 d) const noexcept {
    LightEmission out{{o, normalize(Vec3d(d))}, power()};
    if (visible_) out.ray.from = face_, out.ray.from_ng = Vec3(normal);
    return out;
}

LightSample Lamp::sample_grid(Vec3d p, Vec2 u) const noexcept {
    const GridPoint& point = grid_points_[grid_number(u, grid_)];
    const Vec3d to_lamp = point.q - p;
    const double height = -dot(to_lamp, point.n);
    if (!(height > 0)) return {};
    const double distance = length(to_lamp), inverse = 1 / distance;
    const Rgb L = radiance_ * static_cast<float>(height * area_ * (inverse * inverse * inverse));
    if (!is_finite(L)) return {};
    return {Vec3(to_lamp * inverse), distance, L, 1, true};
}

Plate::Plate(const Affine& to_world, const Params& params)
    : centre(to_world.t), x(to_world.column(0)), y(to_world.column(1)) {
    const Vec3d z = to_world.column(2), across = cross(x, y);
    const double volume = dot(across, z);
    if (!is_finite(centre) || !std::isfinite(volume) || std::abs(volume) <= 1e-9 * length(x) * length(y) * length(z))
        refuse_transform(params, "must not flatten it");
    front = normalize(across) * (volume > 0 ? -1.0 : 1.0);
}

Plate::Aim Plate::aim(Vec3d p, Vec3d wi) const noexcept {
    const Vec3d to_p = p - centre;
    const double height = dot(to_p, front), cosine = -dot(wi, front);
    if (!(height > 0) || !(cosine > 0)) return {};
    const double distance = height / cosine;
    return {distance, cosine, to_p + wi * distance};
}

float finite_density(double pdf) noexcept {
    return pdf < double{std::numeric_limits<float>::max()} ? static_cast<float>(pdf) : 0;
}

LightSample sample_plate_point(const Plate& plate, double area, Rgb radiance, Vec3d p, Vec3d q) noexcept {
    const Vec3d to_lamp = q - p;
    const double distance = length(to_lamp), height = -dot(to_lamp, plate.front);
    if (!(height > 0)) return {};
    const float pdf = finite_density(distance * distance * distance / (area * height));
    if (pdf <= 0) return {};
    return {Vec3(to_lamp * (1 / distance)), distance, radiance, pdf};
}

double similarity_scale(const Affine& to_world, const Params& params, int axes) {
    const double size = length(to_world.column(0));
    if (!(size > 0) || !std::isfinite(size) || !is_finite(to_world.t)) refuse_transform(params, "must not flatten it");
    for (int i = 0; i < axes; ++i)
        for (int j = i; j < axes; ++j) {
            const double wanted = i == j ? 1 : 0;
            const double got = dot(to_world.column(i), to_world.column(j)) / (size * size);
            if (!(std::abs(got - wanted) <= roundness))
                refuse_transform(params, "must scale all axes alike, or it would not stay round");
        }
    return size;
}

int read_grid(const Params& params) {
    constexpr double most = 256;
    const double grid = params.number("grid", 0, 0, most);
    if (grid != std::floor(grid)) params.wrong("grid", "a whole number");
    return static_cast<int>(grid);
}

std::size_t grid_number(Vec2 u, int grid) noexcept {
    const auto side = static_cast<float>(grid);
    const auto at = [&](float x) {
        return std::min(static_cast<std::size_t>(x * side), static_cast<std::size_t>(grid - 1));
    };
    return at(u.y) * static_cast<std::size_t>(grid) + at(u.x);
}

double required_length(const Params& params, const char* name) {
    if (!params.has(name)) params.wrong(name, "given: a length above 0");
    const double length = params.number(name, 0);
    if (length <= 0) params.wrong(name, "above 0");
    return length;
}

}  // namespace cardioid::shaders
