#include "formats/povray/scene/lights.hpp"

#include <fmt/format.h>
#include <functional>
#include <numbers>

#include "rt_core/math/frame.hpp"
#include "rt_core/math/sampling.hpp"

namespace cardioid::formats::povray {

namespace {

constexpr double degree = std::numbers::pi / 180;
/// Lights fall off as 2/(1 + (d/fade)^2): exactly as 1/d^2, but for (fade/d)^2 of it. POV-Ray's units.
constexpr double fade = 1e-3;
constexpr double fade_gain = 1 / (2 * fade * fade);
/// Parallel light comes from a plane so many diagonals of the scene away.
constexpr double far = 10;
/// Radius of the ball that is the studio's backdrop, POV-Ray's units: beyond every scene, within its largest distance.
constexpr double backdrop_distance = 1e6;

class LightWriter {
public:
    LightWriter(const LightSettings& light, const LightSpace& space, const WriteOptions& options, Notes& notes)
        : light_(light), params_(light.params), m_(light.to_world), space_(space), options_(options), notes_(notes) {}

    std::string run() {
        if (light_.kind == "point_light")
            point();
        else if (light_.kind == "spot_light")
            spot();
        else if (light_.kind == "area_light")
            area();
        else if (light_.kind == "disk_light")
            disk();
        else if (light_.kind == "sphere_light")
            sphere();
        else if (light_.kind == "sun")
            sun();
        else if (light_.kind == "sky")
            sky();
        else
            note("POV-Ray has nothing like it; it is left out");
        return std::move(text_);
    }

private:
    void note(const std::string& text) { notes_.add(params_.where(), light_.kind + ": " + text); }

    [[nodiscard]] std::string place(Vec3d p) const { return sdl(p * space_.scale); }
    /// Of an intensity in W/sr of our units.
    [[nodiscard]] std::string colour(Rgb intensity) const {
        return sdl_over_pi(intensity, space_.scale * space_.scale * fade_gain);
    }
    [[nodiscard]] std::string fading() const { return fmt::format("fade_distance {} fade_power 2", sdl(fade)); }
    /// A point's intensity, where `power` is that of intensity 1.
    [[nodiscard]] Rgb intensity(double power) const {
        return params_.has("power") ? params_.colour("power", {}) * static_cast<float>(1 / power)
                                    : params_.colour("intensity", Rgb(1));
    }
    [[nodiscard]] Rgb radiance(double surface) const {
        return params_.has("power") ? params_.colour("power", {}) * static_cast<float>(1 / (std::numbers::pi * surface))
                                    : params_.colour("radiance", Rgb(1));
    }

    void light(Vec3d p, Rgb intensity, const std::string& more) {
        text_ += fmt::format("light_source {{ {} color {} {}{} }}\n", place(p), colour(intensity), more, fading());
    }

    void point() {
        const bool shadows = params_.boolean("shadows", true);
        light(m_.t, intensity(4 * std::numbers::pi), shadows ? "" : "shadowless ");
    }

    void spot() {
        const double angle = params_.number("angle", 30), inner = params_.number("inner", angle);
        if (angle >= 90) return note("POV-Ray's spotlights are narrower than 90 degrees; it is left out");
        const double share = (1 - std::cos(inner * degree)) + (std::cos(inner * degree) - std::cos(angle * degree)) / 2;
        const Vec3d axis = normalize(m_.vector({0, 0, -1}));
        light(m_.t, intensity(2 * std::numbers::pi * share),
              fmt::format("spotlight point_at {} radius {} falloff {} tightness 0 ", sdl(m_.t * space_.scale + axis),
                          sdl(inner), sdl(angle)));
    }

    /// The lamp as fixed points, as parameter `grid` makes it in our own pictures.
    struct Point {
        Vec3d p, n;
    };
    void points(Rgb L, double surface, const std::function<Point(Vec2)>& at) {
        const int own = static_cast<int>(params_.number("grid", 0)), grid = own > 0 ? own : options_.light_grid;
        if (own == 0) note(fmt::format("written as {0} x {0} points; grid = {0} makes it so in our pictures", grid));
        const auto side = static_cast<float>(grid);
        const Rgb each = L * static_cast<float>(surface / (double{side} * double{side}));
        for (int y = 0; y < grid; ++y)
            for (int x = 0; x < grid; ++x) {
                const Point point = at({(static_cast<float>(x) + 0.5F) / side, (static_cast<float>(y) + 0.5F) / side});
                lambert(point, each, "");
            }
    }
    void lambert(const Point& point, Rgb intensity, const std::string& more) {
        light(point.p, intensity,
              fmt::format("spotlight point_at {} radius 90 falloff 90 tightness 1 {}",
                          sdl(point.p * space_.scale + point.n), more));
    }

    [[nodiscard]] bool visible() const { return params_.boolean("visible", true); }
    [[nodiscard]] static std::string shining(Rgb L, bool plate) {
        return fmt::format(" texture {{ pigment {{ {} }} finish {{ emission 1 }} }}{} no_radiosity }}\n", sdl(L),
                           plate ? " interior_texture { pigment { rgb 0 } }" : "");
    }
    /// Local -z, turned as a face turns.
    [[nodiscard]] Vec3d front() const {
        return normalize(cross(m_.column(0), m_.column(1))) * (m_.determinant() > 0 ? -1.0 : 1.0);
    }

    void area() {
        const auto size = params_.vector("size", 2).value_or(std::vector<double>{1, 1});
        const Vec3d x = m_.column(0) * size[0], y = m_.column(1) * size[1], n = front();
        const double surface = length(cross(x, y));
        const Rgb L = radiance(surface);
        if (options_.light_arrays)
            array(L * static_cast<float>(surface), x, y);
        else
            points(L, surface, [&](Vec2 u) {
                return Point{m_.t + x * (double{u.x} - 0.5) + y * (double{u.y} - 0.5), n};
            });
        if (!visible()) return;
        // Seen from its front the plate's corners run counter-clockwise.
        const bool turned = dot(cross(x, y), n) < 0;
        const Vec3d first = turned ? y : x, second = turned ? x : y;
        text_ += fmt::format("polygon {{ 5, {0}, {1}, {2}, {3}, {0}{4}", place(m_.t - (first + second) * 0.5),
                             place(m_.t + (first - second) * 0.5), place(m_.t + (first + second) * 0.5),
                             place(m_.t + (second - first) * 0.5), shining(L, true));
    }

    /// POV-Ray's grid reaches from edge to edge of its axes; shortened so, each point has an equal part around it.
    void array(Rgb intensity, Vec3d x, Vec3d y) {
        note("as one area_light of POV-Ray its half shadows are some percent too dark");
        const int own = static_cast<int>(params_.number("grid", 0));
        const int grid = std::max(2, own > 0 ? own : options_.light_grid);
        const double inside = (grid - 1.0) / grid * space_.scale;
        lambert({m_.t, front()}, intensity,
                fmt::format("area_light {}, {}, {}, {} area_illumination on ", sdl(x * inside), sdl(y * inside), grid,
                            grid));
    }

    void disk() {
        const double radius = params_.number("r", 1), world = radius * length(m_.column(0));
        const double surface = std::numbers::pi * world * world;
        const Rgb L = radiance(surface);
        const Vec3d n = front();
        points(L, surface, [&](Vec2 u) {
            const Vec2d q = Vec2d(sample_disc(u)) * radius;
            return Point{m_.t + m_.column(0) * q.x + m_.column(1) * q.y, n};
        });
        if (visible())
            text_ +=
                fmt::format("disc {{ {}, {}, {}{}", place(m_.t), sdl(n), sdl(world * space_.scale), shining(L, true));
    }

    void sphere() {
        const double radius = params_.number("r", 1) * length(m_.column(0));
        const double surface = 4 * std::numbers::pi * radius * radius;
        const Rgb L = radiance(surface);
        points(L, surface, [&](Vec2 u) {
            const Vec3d n = normalize(Vec3d(sample_sphere(u)));
            return Point{m_.t + n * radius, n};
        });
        if (visible())
            text_ += fmt::format("sphere {{ {}, {}{}", place(m_.t), sdl(radius * space_.scale), shining(L, false));
    }

    void parallel(Vec3d direction, Rgb irradiance) {
        text_ += fmt::format("light_source {{ {} color {} parallel point_at {} }}\n",
                             place(space_.centre - direction * (far * space_.diagonal)), sdl_over_pi(irradiance),
                             place(space_.centre));
    }

    void sun() {
        const auto given = params_.vector("direction", 3).value_or(std::vector<double>{0, 0, -1});
        const Vec3d d = normalize(m_.vector(normalize(Vec3d{given[0], given[1], given[2]})));
        const Rgb E = params_.colour("irradiance", Rgb(1));
        const double half = params_.number("angle", 0.53) / 2 * degree;
        if (half < 0.5e-3 * degree) return parallel(d, E);
        const int own = static_cast<int>(params_.number("grid", 0)), grid = own > 0 ? own : options_.light_grid;
        if (own == 0)
            note(fmt::format("written as {0} x {0} directions; grid = {0} makes it so in our pictures", grid));
        note("its disc is not seen in POV-Ray");
        // A disc of radiance L gives pi sin^2 L to a surface that faces its middle: each part of the solid angle has
        // an equal part of the light.
        const double h = std::sin(half / 2), s = std::sin(half), solid_angle = 4 * std::numbers::pi * h * h;
        const auto share = static_cast<float>(solid_angle / (std::numbers::pi * s * s) / (double{1} * grid * grid));
        const Frame frame{Vec3(-d)};
        for (int y = 0; y < grid; ++y)
            for (int x = 0; x < grid; ++x) {
                const Vec2 u{(static_cast<float>(x) + 0.5F) / static_cast<float>(grid),
                             (static_cast<float>(y) + 0.5F) / static_cast<float>(grid)};
                parallel(-Vec3d(frame.to_world(sample_cone(u, static_cast<float>(2 * h * h)))), E * share);
            }
    }

    void sky() {
        if (!options_.photons) note("the sky is seen, but lights nothing without radiosity (--photons)");
        if (params_.has("file")) return note("a picture of the sky is left out");
        if (params_.has("cie")) return note("a CIE sky is left out");
        if (!params_.is_text("radiance")) {
            text_ += fmt::format("background {{ {} }}\n", sdl(params_.colour("radiance", Rgb(1))));
            return;
        }
        text_ +=
            "sky_sphere { pigment { function { select(z, 0.28 + 0.18*z, 0.28 + 0.32*z*z) }"
            " color_map { [0 rgb 0] [1 rgb 1] } } }\n";
        backdrop();
    }

    /// What the eye sees behind the model is brighter than the light of the studio: a ball around the eye that shines
    /// for nothing else. A colour map takes no value of 1, so its other end is at a half.
    void backdrop() {
        if (!space_.camera) return;
        note("in POV-Ray the studio's backdrop is what is seen through glass too");
        const bool even = space_.camera->projection == CameraSettings::Projection::orthographic;
        const double z = normalize(space_.camera->look_at - space_.camera->eye).z;
        const std::string eye = place(space_.camera->eye), height = even ? sdl(z) : "z";
        text_ += fmt::format(
            "#declare Backdrop = function(s) {{ s*s*(1.5 - s) }};\n"
            "sphere {{ {0}, {1} pigment {{ function {{ Backdrop(min(1, max(0, {2}/0.8 + 1))) }}"
            " color_map {{ [0 rgb 0.72] [0.5 rgb 0.98] }} scale {1} translate {0} }}"
            " finish {{ emission 1 }} hollow no_shadow no_reflection no_radiosity }}\n",
            eye, sdl(backdrop_distance), height);
    }

    const LightSettings& light_;
    const Params& params_;
    const Affine& m_;
    const LightSpace& space_;
    const WriteOptions& options_;
    Notes& notes_;
    std::string text_;
};

}  // namespace

std::string write_lights(const Scene& scene, const LightSpace& space, const WriteOptions& options, Notes& notes) {
    std::string text;
    for (const LightSettings& light : scene.lights) text += LightWriter(light, space, options, notes).run();
    return text;
}

}  // namespace cardioid::formats::povray
