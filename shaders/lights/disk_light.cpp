/// `disk_light`: a flat round lamp.
///
///     translate([0, 0, 99]) disk_light(20, power = 60);
///
/// | parameter  | default | |
/// |------------|---------|---|
/// | `r`        | (given) | radius in its local xy plane [scene units] |
/// | `radiance` | 1       | [W/(sr unit^2)], the same in all directions on the front, local -z |
/// | `power`    |         | [W] instead of radiance: power = pi^2 r^2 radiance |
/// | `visible`  | true    | an opaque plate that rays meet; false: only its light is there |
/// | `grid`     | 0       | K: K x K fixed points in the middle of equal parts instead of the whole lamp |
///
/// Transforms must keep it round. Sampled uniformly over its area.
#include "shaders/lights/lamp.hpp"
#include "shaders/lights/lights.hpp"

namespace cardioid::shaders {
namespace {

class DiskLight final : public Lamp {
public:
    /// radius: local; scale: of to_world.
    DiskLight(const Params& params, const Affine& to_world, double radius, double scale)
        : Lamp(params, {LampShape::Kind::disc, to_world, {radius, radius}},
               std::numbers::pi * radius * radius * scale * scale),
          plate_(to_world, params),
          local_radius_(radius),
          radius_(radius * scale) {
        each_stratum(grid(), [&](Vec2 u) { add_grid_point({point(u), plate_.front}); });
    }

    [[nodiscard]] LightSample sample(Vec3d p, Vec2 u) const noexcept override {
        if (grid() > 0) return sample_grid(p, u);
        return sample_plate_point(plate_, area(), radiance(), p, point(u));
    }
    [[nodiscard]] float pdf(Vec3d p, Vec3 wi) const noexcept override {
        const Plate::Aim aim = plate_.aim(p, Vec3d(wi));
        if (aim.distance <= 0 || dot(aim.q, aim.q) > radius_ * radius_) return 0;
        return finite_density(aim.distance * aim.distance / (area() * aim.cosine));
    }
    [[nodiscard]] LightEmission emit(Vec2 u_place, Vec2 u_direction) const noexcept override {
        return leave(point(u_place), plate_.front, u_direction);
    }
    [[nodiscard]] Rgb emitted(Vec3d, Vec3, Vec3 wo) const noexcept override {
        return dot(Vec3d(wo), plate_.front) > 0 ? radiance() : Rgb{};
    }

private:
    [[nodiscard]] Vec3d point(Vec2 u) const noexcept {
        const Vec2d q = Vec2d(sample_disc(u)) * local_radius_;
        return plate_.centre + plate_.x * q.x + plate_.y * q.y;
    }

    Plate plate_;
    double local_radius_;
    double radius_;  ///< in the world
};

constexpr ParamSpec params[] = {
    {"r", ParamType::number, "", "radius [scene units], above 0"},
    {"radiance", ParamType::colour, "1", "[W/(sr unit^2)] on the front, local -z"},
    {"power", ParamType::colour, "", "[W] instead of radiance; power = pi area radiance"},
    {"visible", ParamType::boolean, "true", "an opaque plate that rays meet; false: only its light"},
    {"grid", ParamType::number, "0", "K: K x K fixed points instead of the whole lamp, as for POV-Ray; 0: none"}};

std::unique_ptr<Light> make(const LightInputs& in) {
    const double radius = required_length(in.params, "r");
    return std::make_unique<DiskLight>(in.params, in.to_world, radius, similarity_scale(in.to_world, in.params, 2));
}

}  // namespace

const LightKind disk_light_kind{"disk_light", "flat round lamp", params, make};

}  // namespace cardioid::shaders
