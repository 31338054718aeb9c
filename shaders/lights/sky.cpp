/// `sky`: light from all directions.
///
///     sky(radiance = [0.4, 0.6, 1]);
///     sky(file = "harbour.exr", rotation = 90);
///     sky("studio");
///     sky(cie = 12, elevation = 40, rotation = 135, radiance = 20);
///
/// | parameter   | default | |
/// |-------------|---------|---|
/// | `radiance`  | 1       | [W/(sr unit^2)], or "studio": the built-in soft dome with a backdrop of its own |
/// | `file`      |         | latitude-longitude picture that OpenImageIO reads; `radiance` then scales it |
/// | `cie`       |         | 1 to 15: the CIE standard general sky of that type; `radiance` is then that of its zenith
/// | | `elevation` | 60      | of the sun over the horizon [deg], 0 to 90, for `cie`: types 1, 3 and 5 do not ask where
/// it is | | `rotation`  | 0       | turns the sky about its z axis [deg], counter-clockwise from above |
///
/// The top of a picture is +z, its middle +x; a CIE sky has its sun over +x, black below the horizon, and no disc of
/// the sun, which `sun()` gives. All but an even sky, which is sampled uniformly, are sampled by their brightness.
/// Transforms around it turn it too.
#include <optional>

#include "shaders/lights/cie_sky.hpp"
#include "shaders/lights/far_light.hpp"
#include "shaders/lights/lamp.hpp"
#include "shaders/lights/lights.hpp"
#include "shaders/lights/sky_image.hpp"
#include "shaders/lights/studio.hpp"

namespace cardioid::shaders {
namespace {

/// From the world to the sky's own directions.
Affine turn(const LightInputs& in) {
    const double scale = similarity_scale(in.to_world, in.params, 3);
    const double a = in.params.number("rotation", 0) * (std::numbers::pi / 180);
    const Affine about_z{{Vec3d{std::cos(a), -std::sin(a), 0}, {std::sin(a), std::cos(a), 0}, {0, 0, 1}}, {}};
    Affine to_world = in.to_world * about_z;
    for (Vec3d& row : to_world.row) row *= 1 / scale;
    to_world.t = {};
    return to_world;
}

/// The parts that every sky has; how bright it is comes from `Look`, whose density is even where it says nothing.
template <class Look>
class Sky final : public FarLight {
public:
    Sky(const Affine& to_world, Look look) : to_world_(to_world), look_(std::move(look)) {}

    [[nodiscard]] LightSample sample(Vec3d, Vec2 u) const noexcept override {
        const LatLongDensity::Drawn drawn = look_.sample(u);
        if (!(drawn.pdf > 0)) return {};
        return {Vec3(to_world_.vector(Vec3d(drawn.d))), std::numeric_limits<double>::infinity(),
                look_.radiance(drawn.d), drawn.pdf};
    }
    [[nodiscard]] float pdf(Vec3d, Vec3 wi) const noexcept override { return look_.pdf(to_local(wi)); }
    [[nodiscard]] LightEmission emit(Vec2 u_place, Vec2 u_direction) const noexcept override {
        const LightSample s = sample({}, u_direction);
        if (is_black(s.L)) return enter({0, 0, -1}, u_place, {});
        return enter(-s.wi, u_place, s.L * (disc_area() / s.pdf));
    }
    [[nodiscard]] Rgb power() const noexcept override { return look_.integral() * disc_area(); }
    [[nodiscard]] Rgb escaped(Vec3 d) const noexcept override { return look_.radiance(to_local(d)); }
    [[nodiscard]] Rgb backdrop(Vec3 d) const noexcept override { return look_.backdrop(to_local(d)); }

private:
    [[nodiscard]] Vec3 to_local(Vec3 d) const noexcept { return Vec3(to_world_.transposed_vector(Vec3d(d))); }

    Affine to_world_;  ///< a rotation
    Look look_;
};

struct EvenLook {
    Rgb L;
    static constexpr float density = inv_pi / 4;
    [[nodiscard]] LatLongDensity::Drawn sample(Vec2 u) const noexcept { return {sample_sphere(u), density}; }
    [[nodiscard]] float pdf(Vec3) const noexcept { return density; }
    [[nodiscard]] Rgb radiance(Vec3) const noexcept { return L; }
    [[nodiscard]] Rgb backdrop(Vec3) const noexcept { return L; }
    [[nodiscard]] Rgb integral() const noexcept { return L * (1 / density); }
};

class StudioLook {
public:
    StudioLook() {
        constexpr std::size_t rows = 128;
        std::vector<float> weights(rows);
        for (std::size_t y = 0; y < rows; ++y)
            weights[y] = studio::radiance(static_cast<float>(std::cos(pi * (static_cast<float>(y) + 0.5F) / rows)));
        density_ = LatLongDensity(1, rows, weights);
    }
    [[nodiscard]] LatLongDensity::Drawn sample(Vec2 u) const noexcept { return density_.sample(u); }
    [[nodiscard]] float pdf(Vec3 d) const noexcept { return density_.pdf(d); }
    [[nodiscard]] Rgb radiance(Vec3 d) const noexcept { return Rgb(studio::radiance(d.z)); }
    [[nodiscard]] Rgb backdrop(Vec3 d) const noexcept { return Rgb(studio::backdrop(d.z)); }
    [[nodiscard]] Rgb integral() const noexcept {
        using namespace studio;
        return Rgb(2 * pi * (horizon + (overhead - horizon) / 3 + horizon - (horizon - ground) / 2));
    }

private:
    LatLongDensity density_;
};

class ImageLook {
public:
    ImageLook(SkyImage image, Rgb scale) : image_(std::move(image)), scale_(scale) {}
    [[nodiscard]] LatLongDensity::Drawn sample(Vec2 u) const noexcept { return image_.density().sample(u); }
    [[nodiscard]] float pdf(Vec3 d) const noexcept { return image_.density().pdf(d); }
    [[nodiscard]] Rgb radiance(Vec3 d) const noexcept { return image_.radiance(d) * scale_; }
    [[nodiscard]] Rgb backdrop(Vec3 d) const noexcept { return radiance(d); }
    [[nodiscard]] Rgb integral() const noexcept { return image_.integral() * scale_; }

private:
    SkyImage image_;
    Rgb scale_;
};

class CieLook {
public:
    CieLook(const CieSky& sky, Rgb zenith) : sky_(sky), zenith_(zenith) {}
    [[nodiscard]] LatLongDensity::Drawn sample(Vec2 u) const noexcept { return sky_.density().sample(u); }
    [[nodiscard]] float pdf(Vec3 d) const noexcept { return sky_.density().pdf(d); }
    [[nodiscard]] Rgb radiance(Vec3 d) const noexcept { return zenith_ * static_cast<float>(sky_.relative(Vec3d(d))); }
    [[nodiscard]] Rgb backdrop(Vec3 d) const noexcept { return radiance(d); }
    [[nodiscard]] Rgb integral() const noexcept { return zenith_ * static_cast<float>(sky_.integral()); }

private:
    CieSky sky_;
    Rgb zenith_;
};

constexpr ParamSpec params[] = {
    {"radiance", ParamType::colour, "1", "[W/(sr unit^2)], or \"studio\" for the built-in dome; scales `file`"},
    {"file", ParamType::text, "", "latitude-longitude picture (EXR, HDR, PNG ...); its top is +z, its middle +x"},
    {"rotation", ParamType::number, "0", "about the z axis [deg], counter-clockwise from above"},
    {"cie", ParamType::number, "", "1 to 15: CIE standard general sky of that type; `radiance` is its zenith's"},
    {"elevation", ParamType::number, "60", "for `cie`: the sun's over the horizon [deg], 0 to 90; it stands over +x"}};

CieSky cie_sky(const Params& given) {
    const double type = given.number("cie", 5, 1, 15);
    if (type != std::floor(type)) given.wrong("cie", "a whole number from 1 to 15");
    if (given.has("file")) given.wrong("file", "left out where the sky is of a CIE type");
    return {static_cast<int>(type), given.number("elevation", 60, 0, 90) * (std::numbers::pi / 180)};
}

std::unique_ptr<Light> make(const LightInputs& in) {
    const Affine to_world = turn(in);
    if (in.params.is_text("radiance")) {
        if (in.params.text("radiance") != "studio")
            in.params.wrong("radiance", "a colour or \"studio\"; found \"" + in.params.text("radiance") +
                                            "\" (a picture is given as file = \"...\")");
        if (in.params.has("file")) in.params.wrong("file", "left out where the sky is the studio");
        if (in.params.has("cie")) in.params.wrong("cie", "left out where the sky is the studio");
        return std::make_unique<Sky<StudioLook>>(to_world, StudioLook{});
    }
    const Rgb radiance = in.params.colour("radiance", Rgb(1));
    if (in.params.has("cie")) return std::make_unique<Sky<CieLook>>(to_world, CieLook{cie_sky(in.params), radiance});
    if (in.params.has("elevation")) in.params.wrong("elevation", "left out where the sky is of no CIE type");
    if (!in.params.has("file")) return std::make_unique<Sky<EvenLook>>(to_world, EvenLook{radiance});
    const std::string file = in.params.text("file");
    const bool relative = !file.starts_with('/') && !in.base_dir.empty();
    return std::make_unique<Sky<ImageLook>>(
        to_world, ImageLook{SkyImage(relative ? in.base_dir + "/" + file : file, in.params.where()), radiance});
}

}  // namespace

const LightKind sky_kind{"sky", "light from all directions: even, of a CIE type, a picture, or the studio", params,
                         make};

}  // namespace cardioid::shaders
