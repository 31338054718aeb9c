#include "formats/povray/scene/scene_writer.hpp"

#include <cmath>
#include <fmt/format.h>
#include <numbers>

#include "formats/povray/scene/lights.hpp"
#include "formats/povray/scene/materials.hpp"
#include "formats/povray/solids/bounds.hpp"
#include "formats/povray/solids/solid_writer.hpp"

namespace cardioid::formats::povray {

namespace {

/// Diagonal of a scene, in POV-Ray's units, from which on its tolerances (up to 1e-3 units) are far below a pixel, and
/// up to which its largest distance (1e7) is far enough.
constexpr double least_diagonal = 100, most_diagonal = 1e4;
/// Levels of reflection and refraction, and the share of light below which a way is given up: those of --lighting
/// whitted.
constexpr int trace_levels = 33;
constexpr const char* least_share = "1e-6";
constexpr double default_photons = 1e6;
/// POV-Ray's aperture in radii of the lens that blurs alike, as measured.
constexpr double apertures = 4;

/// Around all that is bounded: solids, lights, cameras.
Box3d scene_box(const Scene& scene) {
    Box3d box;
    for (const Leaf& leaf : scene.solids.leaves)
        if (const Box3d b = world_box(leaf, scene.solids); !b.empty() && b.bounded()) box.include(b);
    for (const LightSettings& light : scene.lights) box.include(light.to_world.t);
    for (const CameraSettings& camera : scene.cameras) box.include(camera.eye);
    return box;
}

double unit_scale(double diagonal) {
    if (!(diagonal > 0) || (diagonal >= least_diagonal && diagonal <= most_diagonal)) return 1;
    const double wanted = diagonal < least_diagonal ? least_diagonal : most_diagonal;
    const double power = std::log10(wanted / diagonal);
    return std::pow(10.0, diagonal < least_diagonal ? std::ceil(power) : std::floor(power));
}

class SceneWriter {
public:
    SceneWriter(const Scene& scene, const WriteOptions& options) : scene_(scene), options_(options) {
        const Box3d box = scene_box(scene);
        diagonal_ = box.diagonal() > 0 ? box.diagonal() : 1;
        if (!box.empty()) centre_ = box.centre();
        scale_ = unit_scale(diagonal_);
    }

    std::string run() {
        const std::string globals = global_settings(), camera = cameras();
        const Materials materials = write_materials(scene_, scale_, notes_);
        const CameraSettings* eye = scene_.cameras.empty() ? nullptr : &scene_.cameras.front();
        const std::string lights = write_lights(scene_, {scale_, centre_, diagonal_, eye}, options_, notes_);
        const std::string solids = write_solids(scene_, {materials, scale_, diagonal_, options_.photons}, notes_);
        if (options_.notes) options_.notes->insert(options_.notes->end(), notes_.all().begin(), notes_.all().end());
        return head() + globals + camera + materials.declarations + lights + solids;
    }

private:
    [[nodiscard]] std::string head() const {
        std::string text =
            fmt::format("// {}, for POV-Ray 3.7, written by Cardioid " CARDIOID_VERSION "\n", scene_.file);
        text += fmt::format(
            "// povray +Ifile.pov +Ofile.exr +FE +W{} +H{} -D -A +WT1    one sample in the middle of each pixel, "
            "linear\n",
            scene_.film.width.value_or(800), scene_.film.height.value_or(600));
        if (scale_ != 1) text += fmt::format("// {} units here are 1 of the scene\n", sdl(scale_));
        if (!notes_.all().empty()) text += "// What is not, or only nearly, the same in POV-Ray:\n";
        for (const std::string& note : notes_.all()) text += "//   " + note + "\n";
        return text;
    }

    [[nodiscard]] std::string global_settings() const {
        std::string more;
        if (options_.photons) {
            const double count =
                scene_.photons.has("count") ? scene_.photons.number("count", default_photons) : default_photons;
            more = fmt::format(
                "  radiosity {{ count 200 error_bound 0.5 nearest_count 10 recursion_limit 20 pretrace_end 0.02 }}\n"
                "  photons {{ count {} autostop 0 gather 20, 40 }}\n",
                sdl(count));
        }
        return fmt::format(
            "#version 3.7;\nglobal_settings {{\n  assumed_gamma 1 adc_bailout {} max_trace_level {}\n{}}}\n"
            "#default {{ pigment {{ rgb 0 }} finish {{ ambient 0 diffuse 0 }} }}\n",
            least_share, trace_levels, more);
    }

    /// Explicit vectors, so that nothing of POV-Ray's left-handed view gets in: eye, forward, right, up.
    std::string cameras() {
        if (scene_.cameras.empty()) return "";
        std::string text = "#declare Aspect = image_width/image_height;\n";
        Identifiers names;
        std::string first;
        for (const CameraSettings& camera : scene_.cameras) {
            const std::string id = names.make("Camera_", camera.name);
            if (first.empty()) first = id;
            text += fmt::format("#declare {} = {}\n", id, one_camera(camera));
        }
        return text + fmt::format("camera {{ {} }}\n", first);
    }

    std::string one_camera(const CameraSettings& camera) {
        const Vec3d gaze = camera.look_at - camera.eye, forward = normalize(gaze);
        Vec3d right;
        for (const Vec3d up : {camera.up, Vec3d{0, 1, 0}, Vec3d{1, 0, 0}}) {
            right = cross(forward, up);
            if (length(right) > 1e-6 * length(up)) break;
        }
        right = normalize(right);
        const Vec3d up = cross(right, forward);
        const bool orthographic = camera.projection == CameraSettings::Projection::orthographic;
        const double across =
            orthographic ? camera.width * scale_ : 2 * std::tan(camera.fov_deg / 2 * std::numbers::pi / 180);
        const bool wide = orthographic || camera.fov_is_horizontal;
        std::string lens;
        if (!orthographic && camera.lens_radius > 0) {
            const double focus = camera.focus > 0 ? camera.focus : length(gaze);
            lens =
                fmt::format(" aperture {} focal_point {} blur_samples 128 variance 0",
                            sdl(apertures * camera.lens_radius * scale_), sdl((camera.eye + forward * focus) * scale_));
        }
        return fmt::format("camera {{ {} location {} direction {} right {}*{}{} up {}*{}{}{} }}",
                           orthographic ? "orthographic" : "perspective", sdl(camera.eye * scale_), sdl(forward),
                           sdl(right), sdl(across), wide ? "" : "*Aspect", sdl(up), sdl(across), wide ? "/Aspect" : "",
                           lens);
    }

    const Scene& scene_;
    const WriteOptions& options_;
    Notes notes_;
    Vec3d centre_;
    double diagonal_ = 1, scale_ = 1;
};

}  // namespace

std::string write_scene(const Scene& scene, const WriteOptions& options) { return SceneWriter(scene, options).run(); }

}  // namespace cardioid::formats::povray
