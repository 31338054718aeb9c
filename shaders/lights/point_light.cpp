/// `point_light`: light from one point, the same in all directions.
///
///     translate([10, 0, 50]) point_light(intensity = 1000);
///
/// | parameter   | default | |
/// |-------------|---------|---|
/// | `intensity` | 1       | [W/sr] |
/// | `power`     |         | [W] instead of intensity: power = 4 pi intensity |
/// | `shadows`   | true    | false: shines through everything |
///
/// Irradiance at distance d is intensity cos/d^2, exactly.
#include "shaders/lights/lights.hpp"
#include "shaders/lights/point_source.hpp"

namespace cardioid::shaders {
namespace {

constexpr double sphere_solid_angle = 4 * std::numbers::pi;

class PointLight final : public Light {
public:
    explicit PointLight(const LightInputs& in)
        : place_(point_place(in)),
          intensity_(read_intensity(in.params, sphere_solid_angle)),
          shadows_(in.params.boolean("shadows", true)) {}

    [[nodiscard]] LightSample sample(Vec3d p, Vec2) const noexcept override {
        return sample_point(place_, p, intensity_);
    }
    [[nodiscard]] float pdf(Vec3d, Vec3) const noexcept override { return 0; }
    [[nodiscard]] LightEmission emit(Vec2, Vec2 u_direction) const noexcept override {
        return {{place_, normalize(Vec3d(sample_sphere(u_direction)))}, power()};
    }
    [[nodiscard]] Rgb power() const noexcept override { return intensity_ * static_cast<float>(sphere_solid_angle); }
    [[nodiscard]] bool casts_shadows() const noexcept override { return shadows_; }

private:
    Vec3d place_;
    Rgb intensity_;
    bool shadows_;
};

constexpr ParamSpec params[] = {{"intensity", ParamType::colour, "1", "[W/sr]"},
                                {"power", ParamType::colour, "", "[W] instead of intensity; power = 4 pi intensity"},
                                {"shadows", ParamType::boolean, "true", "false: shines through everything"}};

std::unique_ptr<Light> make(const LightInputs& in) { return std::make_unique<PointLight>(in); }

}  // namespace

const LightKind point_light_kind{"point_light", "light from one point", params, make};

}  // namespace cardioid::shaders
