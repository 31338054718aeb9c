/// `sphere_light`: a shining ball.
///
///     translate([0, 0, 80]) sphere_light(5, power = 60);
///
/// | parameter  | default | |
/// |------------|---------|---|
/// | `r`        | (given) | radius [scene units] |
/// | `radiance` | 1       | [W/(sr unit^2)], the same in all directions outwards |
/// | `power`    |         | [W] instead of radiance: power = 4 pi^2 r^2 radiance |
/// | `visible`  | true    | an opaque ball that rays meet; false: only its light is there |
/// | `grid`     | 0       | K: K x K fixed points in the middle of equal parts instead of the whole lamp |
///
/// Transforms must keep it round. Sampled uniformly over the cone under which the ball is seen; 1 - cos of that cone
/// comes from sin^2 = r^2/d^2, so that far lamps lose no digits. Nothing is lit inside the ball.
#include <cmath>

#include "shaders/lights/lamp.hpp"
#include "shaders/lights/lights.hpp"

namespace cardioid::shaders {
namespace {

class SphereLight final : public Lamp {
public:
    /// radius: local; scale: of to_world.
    SphereLight(const Params& params, const Affine& to_world, double radius, double scale)
        : Lamp(params, {LampShape::Kind::sphere, to_world, {radius, radius}},
               4 * std::numbers::pi * radius * radius * scale * scale),
          centre_(to_world.t),
          radius_(radius * scale) {
        each_stratum(grid(), [&](Vec2 u) {
            const Vec3d n = normalize(Vec3d(sample_sphere(u)));
            add_grid_point({centre_ + n * radius_, n});
        });
    }

    [[nodiscard]] LightSample sample(Vec3d p, Vec2 u) const noexcept override {
        if (grid() > 0) return sample_grid(p, u);
        const Cone cone = cone_from(p);
        if (cone.pdf() <= 0) return {};
        const double drop = double{u.x} * cone.one_minus_cos, sin2 = drop * (2 - drop);
        const double phi = 2 * std::numbers::pi * double{u.y}, sine = std::sqrt(sin2);
        const Frame frame{Vec3(cone.axis)};
        const Vec3d wi =
            Vec3d(frame.s) * (sine * std::cos(phi)) + Vec3d(frame.t) * (sine * std::sin(phi)) + cone.axis * (1 - drop);
        const double half = std::sqrt(std::max(0.0, radius_ * radius_ - cone.distance * cone.distance * sin2));
        return {Vec3(wi), cone.distance * (1 - drop) - half, radiance(), cone.pdf()};
    }
    [[nodiscard]] float pdf(Vec3d p, Vec3 wi) const noexcept override {
        const Cone cone = cone_from(p);
        // 1 - cos of the angle to the axis, from the chord.
        const Vec3d chord = normalize(Vec3d(wi)) - cone.axis;
        return dot(chord, chord) / 2 <= cone.one_minus_cos ? cone.pdf() : 0;
    }
    [[nodiscard]] LightEmission emit(Vec2 u_place, Vec2 u_direction) const noexcept override {
        // Lambert's distribution about all normals is, seen the other way, that of normals about all directions.
        // Numbers that mean a direction in the world let photons be aimed.
        const Vec3 d = sample_sphere(u_direction);
        const Vec3d normal = normalize(Vec3d(Frame(d).to_world(sample_cosine_hemisphere(u_place))));
        return leave_along(centre_ + normal * radius_, normal, d);
    }
    [[nodiscard]] Rgb emitted(Vec3d, Vec3 ng, Vec3 wo) const noexcept override {
        return dot(ng, wo) > 0 ? radiance() : Rgb{};
    }

private:
    /// The cone under which the ball is seen; one_minus_cos is 0 from inside.
    struct Cone {
        Vec3d axis;
        double distance = 0, one_minus_cos = 0;
        [[nodiscard]] float pdf() const {
            return one_minus_cos > 0 ? finite_density(1 / (2 * std::numbers::pi * one_minus_cos)) : 0;
        }
    };
    [[nodiscard]] Cone cone_from(Vec3d p) const noexcept {
        const Vec3d to_centre = centre_ - p;
        const double distance = length(to_centre);
        if (!(distance > radius_)) return {};
        const double sine = radius_ / distance, sin2 = sine * sine;
        return {to_centre / distance, distance, sin2 / (1 + std::sqrt(1 - sin2))};
    }

    Vec3d centre_;
    double radius_;  ///< in the world
};

constexpr ParamSpec params[] = {
    {"r", ParamType::number, "", "radius [scene units], above 0"},
    {"radiance", ParamType::colour, "1", "[W/(sr unit^2)]"},
    {"power", ParamType::colour, "", "[W] instead of radiance; power = pi area radiance"},
    {"visible", ParamType::boolean, "true", "an opaque ball that rays meet; false: only its light"},
    {"grid", ParamType::number, "0", "K: K x K fixed points instead of the whole lamp, as for POV-Ray; 0: none"}};

std::unique_ptr<Light> make(const LightInputs& in) {
    const double radius = required_length(in.params, "r");
    return std::make_unique<SphereLight>(in.params, in.to_world, radius, similarity_scale(in.to_world, in.params, 3));
}

}  // namespace

const LightKind sphere_light_kind{"sphere_light", "shining ball", params, make};

}  // namespace cardioid::shaders
