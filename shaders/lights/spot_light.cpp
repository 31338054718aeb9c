/// `spot_light`: a cone of light from one point, along local -z.
///
///     translate([0, 0, 50]) spot_light(intensity = 1000, angle = 20, inner = 15);
///
/// | parameter   | default | |
/// |-------------|---------|---|
/// | `intensity` | 1       | [W/sr] on the axis |
/// | `power`     |         | [W] instead of intensity |
/// | `angle`     | 30      | half angle of the cone [deg], above 0, at most 180 |
/// | `inner`     | `angle` | half angle of its evenly lit part [deg], 0 to `angle`; equal: a sharp edge |
///
/// At an angle theta from the axis the intensity is scaled by s^2 (3 - 2 s), where s goes from 0 at `angle` to 1 at
/// `inner` linearly in cos theta. That step integrates to one half, so
///     power = 2 pi intensity ((1 - cos inner) + (cos inner - cos angle)/2).
#include "shaders/lights/lights.hpp"
#include "shaders/lights/point_source.hpp"

namespace cardioid::shaders {
namespace {

/// 1 - cos of an angle in degrees, without loss for small ones.
double one_minus_cos(double angle_deg) {
    const double s = std::sin(angle_deg * (std::numbers::pi / 360));
    return 2 * s * s;
}

/// s with 2 s^3 - s^4 = u, the share of the step's flux below s; the left side rises from 0 to 1.
double inverse_step_share(double u) {
    double lo = 0, hi = 1;
    for (int i = 0; i < 40; ++i) {
        const double s = (lo + hi) / 2;
        (s * s * s * (2 - s) < u ? lo : hi) = s;
    }
    return (lo + hi) / 2;
}

class SpotLight final : public Light {
public:
    SpotLight(const LightInputs& in, double angle, double inner)
        : place_(point_place(in)),
          outer_drop_(one_minus_cos(angle)),
          inner_drop_(one_minus_cos(inner)),
          solid_angle_(std::numbers::pi * (inner_drop_ + outer_drop_)),
          intensity_(read_intensity(in.params, solid_angle_)) {
        const Vec3d axis = in.to_world.vector({0, 0, -1});
        const double size = length(axis);
        if (!(size > 0) || !std::isfinite(size))
            throw Error(ErrorCode::bad_input,
                        in.params.where() + ": the transform around this light must not flatten it");
        axis_ = axis / size;
    }

    [[nodiscard]] LightSample sample(Vec3d p, Vec2) const noexcept override {
        LightSample s = sample_point(place_, p, intensity_);
        if (s.distance > 0) s.L *= falloff((p - place_) / s.distance);
        return is_black(s.L) ? LightSample{} : s;
    }
    [[nodiscard]] float pdf(Vec3d, Vec3) const noexcept override { return 0; }
    /// Directions have the density of the intensity, so that all photons carry the same flux.
    [[nodiscard]] LightEmission emit(Vec2, Vec2 u) const noexcept override {
        const double flat = 2 * inner_drop_ / (inner_drop_ + outer_drop_), x = double{u.x};
        const double drop =
            x < flat ? inner_drop_ * (x / flat)
                     : outer_drop_ - inverse_step_share((x - flat) / (1 - flat)) * (outer_drop_ - inner_drop_);
        const double r = std::sqrt(std::max(0.0, drop * (2 - drop))), phi = 2 * std::numbers::pi * double{u.y};
        const Frame frame{Vec3(axis_)};
        const Vec3d d =
            Vec3d(frame.s) * (r * std::cos(phi)) + Vec3d(frame.t) * (r * std::sin(phi)) + axis_ * (1 - drop);
        return {{place_, normalize(d)}, power()};
    }
    [[nodiscard]] Rgb power() const noexcept override { return intensity_ * static_cast<float>(solid_angle_); }

private:
    /// d: unit, away from the light.
    [[nodiscard]] float falloff(Vec3d d) const noexcept {
        const Vec3d chord = d - axis_;
        const double drop = dot(chord, chord) / 2;
        if (drop <= inner_drop_) return 1;
        if (drop >= outer_drop_) return 0;
        const double s = (outer_drop_ - drop) / (outer_drop_ - inner_drop_);
        return static_cast<float>(s * s * (3 - 2 * s));
    }

    Vec3d place_, axis_;
    double outer_drop_, inner_drop_;  ///< 1 - cos of the half angles
    double solid_angle_;              ///< power over intensity
    Rgb intensity_;
};

constexpr ParamSpec params[] = {
    {"intensity", ParamType::colour, "1", "[W/sr] on the axis, local -z"},
    {"power", ParamType::colour, "", "[W] instead of intensity"},
    {"angle", ParamType::number, "30", "half angle of the cone [deg], above 0, at most 180"},
    {"inner", ParamType::number, "angle", "half angle of its evenly lit part [deg], 0 to angle"}};

std::unique_ptr<Light> make(const LightInputs& in) {
    const double angle = in.params.number("angle", 30, 0, 180);
    if (angle <= 0) in.params.wrong("angle", "above 0");
    return std::make_unique<SpotLight>(in, angle, in.params.number("inner", angle, 0, angle));
}

}  // namespace

const LightKind spot_light_kind{"spot_light", "cone of light from one point", params, make};

}  // namespace cardioid::shaders
