/// `sun`: light from far away along one direction.
///
///     sun([-1, 0.5, -2], irradiance = 3, angle = 0.53);
///
/// | parameter    | default | |
/// |--------------|---------|---|
/// | `direction`  | (given) | [x, y, z] the light travels, turned by the transforms around it |
/// | `irradiance` | 1       | [W/unit^2] on a surface that faces the sun |
/// | `angle`      | 0.53    | full apparent diameter [deg], 0 to 180; 0: parallel light with sharp shadows |
/// | `grid`       | 0       | K: K x K fixed directions in the middle of equal parts instead of the whole disc |
///
/// A disc of even radiance irradiance/(pi sin^2(angle/2)), sampled uniformly over its solid angle.
#include "shaders/lights/far_light.hpp"
#include "shaders/lights/lamp.hpp"
#include "shaders/lights/lights.hpp"

namespace cardioid::shaders {
namespace {

class Sun final : public FarLight {
public:
    /// direction: unit, the light travels; half_angle in radians.
    Sun(Vec3d direction, Rgb irradiance, double half_angle, int grid)
        : direction_(direction), irradiance_(irradiance), parallel_(half_angle <= 0), grid_(parallel_ ? 0 : grid) {
        const double s = std::sin(half_angle), h = std::sin(half_angle / 2);
        one_minus_cos_ = 2 * h * h;
        if (!parallel_) radiance_ = irradiance * static_cast<float>(1 / (std::numbers::pi * s * s));
        each_stratum(grid_, [&](Vec2 u) { grid_directions_.push_back(towards(u)); });
    }

    [[nodiscard]] LightSample sample(Vec3d, Vec2 u) const noexcept override {
        constexpr double far = std::numeric_limits<double>::infinity();
        if (parallel_) return {Vec3(-direction_), far, irradiance_, 1, true};
        if (grid_ > 0) return {grid_directions_[grid_number(u, grid_)], far, radiance_ * (1 / pdf()), 1, true};
        return {towards(u), far, radiance_, pdf()};
    }
    [[nodiscard]] float pdf(Vec3d, Vec3 wi) const noexcept override { return meets(wi) ? pdf() : 0; }
    [[nodiscard]] LightEmission emit(Vec2 u_place, Vec2 u_direction) const noexcept override {
        return enter(parallel_ ? Vec3(direction_) : -towards(u_direction), u_place, power());
    }
    [[nodiscard]] Rgb power() const noexcept override {
        return (parallel_ ? irradiance_ : radiance_ * (1 / pdf())) * disc_area();
    }
    [[nodiscard]] int grid() const noexcept override { return grid_; }
    [[nodiscard]] Rgb escaped(Vec3 d) const noexcept override { return meets(d) ? radiance_ : Rgb{}; }

private:
    [[nodiscard]] float pdf() const noexcept { return static_cast<float>(1 / (2 * std::numbers::pi * one_minus_cos_)); }
    [[nodiscard]] Vec3 towards(Vec2 u) const noexcept {
        return Frame(Vec3(-direction_)).to_world(sample_cone(u, static_cast<float>(one_minus_cos_)));
    }
    [[nodiscard]] bool meets(Vec3 d) const noexcept {
        if (parallel_) return false;
        const Vec3d chord = normalize(Vec3d(d)) + direction_;
        return dot(chord, chord) / 2 <= one_minus_cos_;
    }

    Vec3d direction_;
    Rgb irradiance_, radiance_;
    bool parallel_;
    int grid_;
    double one_minus_cos_;  ///< of half its apparent diameter
    std::vector<Vec3> grid_directions_;
};

constexpr ParamSpec params[] = {
    {"direction", ParamType::vector, "", "[x, y, z] the light travels"},
    {"irradiance", ParamType::colour, "1", "[W/unit^2] on a surface that faces the sun"},
    {"angle", ParamType::number, "0.53", "full apparent diameter [deg], 0 to 180; 0: parallel light"},
    {"grid", ParamType::number, "0", "K: K x K fixed directions instead of the whole disc, as for POV-Ray; 0: none"}};

/// Thinner than floats resolve: parallel.
constexpr double thinnest_deg = 1e-3;

std::unique_ptr<Light> make(const LightInputs& in) {
    const auto d = in.params.vector("direction", 3);
    if (!d) in.params.wrong("direction", "given: [x, y, z]");
    const Vec3d given{(*d)[0], (*d)[1], (*d)[2]};
    const double largest = max_component(abs(given));
    if (!(largest > 0)) in.params.wrong("direction", "a direction, not [0, 0, 0]");
    const Vec3d world = in.to_world.vector(given / largest);
    if (!is_finite(world) || !(length(world) > 0))
        throw Error(ErrorCode::bad_input, in.params.where() + ": the transform around this light must not flatten it");
    const double angle = in.params.number("angle", 0.53, 0, 180);
    const double half_angle = angle < thinnest_deg ? 0 : angle * (std::numbers::pi / 360);
    return std::make_unique<Sun>(normalize(world), in.params.colour("irradiance", Rgb(1)), half_angle,
                                 read_grid(in.params));
}

}  // namespace

const LightKind sun_kind{"sun", "light from far away along one direction", params, make};

}  // namespace cardioid::shaders
