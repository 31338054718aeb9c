/// `area_light`: a flat rectangular lamp.
///
///     translate([0, 0, 99]) area_light([40, 20], radiance = [18, 16, 8]);
///     area_light([40, 20], power = 100, visible = false);
///
/// | parameter  | default | |
/// |------------|---------|---|
/// | `size`     | (given) | [width, height] in its local xy plane [scene units], about the local origin |
/// | `radiance` | 1       | [W/(sr unit^2)], the same in all directions on the front, local -z |
/// | `power`    |         | [W] instead of radiance: power = pi area radiance |
/// | `visible`  | true    | an opaque plate that rays meet; false: only its light is there |
/// | `grid`     | 0       | K: K x K fixed points in the middle of equal parts instead of the whole lamp |
///
/// Any transform that does not flatten it is good; a sheared one makes a parallelogram. Rectangles are sampled
/// uniformly over the solid angle they are seen under, parallelograms and rectangles farther away than one and a half
/// times their diagonal over their area.
#include "rt_core/api/solid_angle_rectangle.hpp"
#include "shaders/lights/lamp.hpp"
#include "shaders/lights/lights.hpp"

namespace cardioid::shaders {
namespace {

/// Solid angles below this are better taken as area cos / d^2: the difference of angles that makes them has few digits
/// left, and the two densities hardly differ.
constexpr double far_solid_angle = 1e-3;
/// Nor do they from farther away than so many half diagonals of the lamp, where it is the quicker way by far: on the
/// Cornell box 4 instead of 3 take 2 % off the variance and add 8 % to the time.
constexpr double far_away = 3;

class AreaLight final : public Lamp {
public:
    AreaLight(const Params& params, const Affine& to_world, Vec2d size)
        : AreaLight(params, to_world, size, Plate(to_world, params)) {}

    [[nodiscard]] LightSample sample(Vec3d p, Vec2 u) const noexcept override {
        if (grid() > 0) return sample_grid(p, u);
        if (!(dot(p - plate_.centre, plate_.front) > 0)) return {};
        if (is_near(p)) {
            const SolidAngleRectangle seen = seen_from(p);
            if (seen.solid_angle() > far_solid_angle) {
                const Vec3d to_lamp = seen.sample(Vec2d(u));
                const double distance = length(to_lamp);
                if (!std::isfinite(distance)) return {};
                return {Vec3(to_lamp / distance), distance, radiance(), static_cast<float>(1 / seen.solid_angle())};
            }
        }
        return sample_plate_point(plate_, area(), radiance(), p, point(u));
    }
    [[nodiscard]] float pdf(Vec3d p, Vec3 wi) const noexcept override {
        const Plate::Aim aim = plate_.aim(p, Vec3d(wi));
        if (aim.distance <= 0 || std::abs(dot(aim.q, to_x_)) > 0.5 || std::abs(dot(aim.q, to_y_)) > 0.5) return 0;
        if (is_near(p)) {
            const double solid_angle = seen_from(p).solid_angle();
            if (solid_angle > far_solid_angle) return static_cast<float>(1 / solid_angle);
        }
        return finite_density(aim.distance * aim.distance / (area() * aim.cosine));
    }
    [[nodiscard]] LightEmission emit(Vec2 u_place, Vec2 u_direction) const noexcept override {
        return leave(point(u_place), plate_.front, u_direction);
    }
    [[nodiscard]] Rgb emitted(Vec3d, Vec3, Vec3 wo) const noexcept override {
        return dot(Vec3d(wo), plate_.front) > 0 ? radiance() : Rgb{};
    }

private:
    AreaLight(const Params& params, const Affine& to_world, Vec2d size, const Plate& plate)
        : Lamp(params, {LampShape::Kind::rectangle, to_world, size}, length(cross(plate.x * size.x, plate.y * size.y))),
          plate_(plate),
          edge_x_(plate.x * size.x),
          edge_y_(plate.y * size.y),
          width_(length(edge_x_)),
          height_(length(edge_y_)) {
        const Vec3d n = cross(edge_x_, edge_y_);
        along_x_ = edge_x_ / width_;
        along_y_ = normalize(edge_y_ - along_x_ * dot(edge_y_, along_x_));
        to_x_ = cross(edge_y_, n) / dot(cross(edge_y_, n), edge_x_);
        to_y_ = cross(n, edge_x_) / dot(cross(n, edge_x_), edge_y_);
        // Six digits of a rotation in the file leave corners this far from square.
        right_angled_ = std::abs(dot(edge_x_, edge_y_)) < 1e-5 * width_ * height_;
        each_stratum(grid(), [&](Vec2 u) { add_grid_point({point(u), plate_.front}); });
    }
    /// Whether the solid angle is worth its while.
    [[nodiscard]] bool is_near(Vec3d p) const noexcept {
        const Vec3d d = p - plate_.centre;
        return right_angled_ && dot(d, d) < far_away * far_away / 4 * (width_ * width_ + height_ * height_);
    }
    [[nodiscard]] Vec3d point(Vec2 u) const noexcept {
        return plate_.centre + edge_x_ * (double{u.x} - 0.5) + edge_y_ * (double{u.y} - 0.5);
    }
    [[nodiscard]] SolidAngleRectangle seen_from(Vec3d p) const noexcept {
        const Vec3d corner = plate_.centre - (edge_x_ + edge_y_) * 0.5 - p;
        return {corner, along_x_, along_y_, width_, height_};
    }

    Plate plate_;
    Vec3d edge_x_, edge_y_;    ///< full, in the world
    Vec3d along_x_, along_y_;  ///< unit, at right angles
    Vec3d to_x_, to_y_;        ///< dot(to_x_, q) is q's share of edge_x_
    double width_, height_;
    bool right_angled_ = false;
};

constexpr ParamSpec params[] = {
    {"size", ParamType::vector, "", "[width, height] in its local xy plane [scene units], above 0"},
    {"radiance", ParamType::colour, "1", "[W/(sr unit^2)] on the front, local -z"},
    {"power", ParamType::colour, "", "[W] instead of radiance; power = pi area radiance"},
    {"visible", ParamType::boolean, "true", "an opaque plate that rays meet; false: only its light"},
    {"grid", ParamType::number, "0", "K: K x K fixed points instead of the whole lamp, as for POV-Ray; 0: none"}};

std::unique_ptr<Light> make(const LightInputs& in) {
    const auto size = in.params.vector("size", 2);
    if (!size) in.params.wrong("size", "given: [width, height]");
    if ((*size)[0] <= 0 || (*size)[1] <= 0) in.params.wrong("size", "[width, height], both above 0");
    return std::make_unique<AreaLight>(in.params, in.to_world, Vec2d{(*size)[0], (*size)[1]});
}

}  // namespace

const LightKind area_light_kind{"area_light", "flat rectangular lamp", params, make};

}  // namespace cardioid::shaders
