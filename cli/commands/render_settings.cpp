#include "cli/commands/render_settings.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "cli/options/values.hpp"
#include "rt_core/render/memory_limit.hpp"

namespace cardioid::cli {
namespace {

const CameraSettings& named_camera(const std::string& name, const Scene& scene) {
    std::vector<std::string> known;
    for (const CameraSettings& camera : scene.cameras) {
        if (camera.name == name) return camera;
        known.push_back(camera.name);
    }
    throw Error(ErrorCode::usage,
                fmt::format("--camera: {} has no camera \"{}\"{}{}", scene.file, name,
                            known.empty() ? ", nor any other" : ", wanted " + either(known), suggestion(name, known)));
}

CameraSettings placed_camera(const RenderOptions& options, const Box3d& model) {
    CameraSettings camera;
    camera.eye = *options.eye;
    camera.look_at = options.target.value_or(model.bounded() ? model.centre() : Vec3d{});
    const Vec3d gaze = camera.look_at - camera.eye;
    if (gaze == Vec3d{}) throw Error(ErrorCode::usage, "--eye and --target are the same point");
    // Straight up or down, z tells nothing about what is up in the picture.
    if (std::hypot(gaze.x, gaze.y) < 1e-6 * length(gaze)) camera.up = {0, 1, 0};
    return camera;
}

/// Of a scene without a camera, or from where -a and -e say. An angle of view asks for perspective.
CameraSettings camera_around(const RenderOptions& options, const FittedView& view, const Box3d& model, double aspect) {
    const double azimuth_deg = options.azimuth_deg.value_or(view.azimuth_deg);
    const double elevation_deg = options.elevation_deg.value_or(view.elevation_deg);
    CameraSettings camera = view.parallel && !options.fov_deg
                                ? automatic_view(model, azimuth_deg, elevation_deg, view.width)
                                : fitted_camera(model, azimuth_deg, elevation_deg,
                                                options.fov_deg.value_or(CameraSettings{}.fov_deg), aspect);
    camera.pixel_shift = view.pixel_shift;
    return camera;
}

CameraSettings choose_camera(const RenderOptions& options, const Scene& scene, const Box3d& model, double aspect) {
    CameraSettings camera;
    const bool around = options.azimuth_deg || options.elevation_deg;
    if (options.eye)
        camera = placed_camera(options, model);
    else if (!options.camera.empty())
        camera = named_camera(options.camera, scene);
    else if (!around && !scene.cameras.empty())
        camera = scene.cameras.front();
    else
        return camera_around(options, scene.fitted, model, aspect);
    if (options.fov_deg) {
        if (camera.projection == CameraSettings::Projection::orthographic)
            throw Error(ErrorCode::usage,
                        fmt::format("--fov has no meaning for the orthographic camera \"{}\"", camera.name));
        camera.fov_deg = *options.fov_deg;
        camera.fov_is_horizontal = false;
    }
    return camera;
}

std::array<int, 4> checked_crop(const std::array<int, 4>& crop, int width, int height) {
    const auto [x0, y0, x1, y1] = crop;
    if (x0 < 0 || y0 < 0 || x0 >= x1 || y0 >= y1 || x1 > width || y1 > height)
        throw Error(ErrorCode::usage,
                    fmt::format("--crop: found {},{},{},{}, wanted 0 <= x0 < x1 <= {} and 0 <= y0 < y1 <= {}", x0, y0,
                                x1, y1, width, height));
    return crop;
}

std::string checked_view(const std::string& view, const LightingModule& lighting) {
    if (view.empty()) return view;
    std::vector<std::string> known = view_names();
    const std::vector<std::string> more = lighting.views();
    known.insert(known.end(), more.begin(), more.end());
    return to_choice("--view", view, known);
}

/// With --time or --noise samples are a limit, and only where they were asked for.
int choose_samples(const RenderOptions& options, const Scene& scene) {
    if (options.samples) return *options.samples;
    if (options.quality_samples) return *options.quality_samples;
    if (options.time_s > 0 || options.noise > 0) return 0;
    return scene.film.samples.value_or(RenderSettings{}.samples);
}

}  // namespace

std::array<int, 2> picture_size(const RenderOptions& options, const Scene& scene) {
    const RenderSettings defaults;
    const auto size = options.size.value_or(
        std::array<int, 2>{scene.film.width.value_or(defaults.width), scene.film.height.value_or(defaults.height)});
    constexpr double channels = 3;
    require_memory(static_cast<double>(size[0]) * size[1] * channels * sizeof(float),
                   fmt::format("a picture of {}x{} pixels", size[0], size[1]));
    return size;
}

RenderSettings render_settings(const RenderOptions& options, const Scene& scene, const Box3d& model,
                               const LightingModule& lighting) {
    RenderSettings settings;
    const auto [width, height] = picture_size(options, scene);
    settings.width = width;
    settings.height = height;
    if (options.crop) settings.crop = checked_crop(*options.crop, width, height);
    settings.samples = choose_samples(options, scene);
    settings.seed = options.seed;
    settings.camera = choose_camera(options, scene, model, static_cast<double>(width) / height);
    settings.time_s = options.time_s;
    settings.noise = options.noise;
    if (options.gaussian_filter) settings.filter = Filter::gaussian;
    settings.layers = options.layers;
    settings.view = checked_view(options.view, lighting);
    return settings;
}

}  // namespace cardioid::cli
