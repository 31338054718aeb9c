#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "rt_core/api/lighting.hpp"
#include "rt_core/image/film.hpp"
#include "rt_core/render/committed_scene.hpp"

namespace cardioid {

enum class Filter { box, gaussian };

struct RenderSettings {
    int width = 800, height = 600;
    /// x0, y0, x1, y1 in pixels, end exclusive; all 0: the whole picture. The film is as large as the crop, its pixels
    /// are those of the whole picture bit for bit.
    std::array<int, 4> crop{0, 0, 0, 0};
    int samples = 32;  ///< a pixel; 1 goes through pixel centres; 0: as many as time_s and noise take
    std::uint32_t seed = 0;
    Filter filter = Filter::box;
    CameraSettings camera;
    double time_s = 0;                ///< > 0: ends after this time, at the latest after `samples`
    double noise = 0;                 ///< > 0: until the picture's relative error is below; see NoisePlan
    std::vector<std::string> layers;  ///< of layer_names()
    std::string view;                 ///< a debug picture instead of the beauty: view_names() or one of the module's
};

/// What a render did, for `--stats` and the last line.
struct RenderStatistics {
    std::uint64_t camera_rays = 0, shadow_rays = 0, specular_rays = 0;
    std::uint64_t bounce_rays = 0;  ///< of paths that go on from surfaces of any kind
    int samples = 0;                ///< a pixel, on average, rounded down
    double seconds = 0;             ///< of the render phase
    double cpu_seconds = 0;  ///< that its threads have worked on tiles; nothing else the program does meanwhile counts
    std::uint64_t bad_samples = 0;  ///< NaN, infinite or negative: replaced by black
    std::array<int, 2> first_bad_pixel{-1, -1};
    bool interrupted = false;
    double noise = 0;  ///< of the picture where RenderSettings::noise was asked for, as NoisePlan last measured it
};

/// Layer normal is the mean of the unit normals towards +ng, depth the distance from the ray's origin averaged over the
/// samples that met something (0 where none did), region the id of the first sample that did (else -1).
struct RenderResult {
    Film film;
    RenderStatistics statistics;
};

/// Names for RenderSettings::layers: direct, indirect, caustic, specular, emission, normal, depth, albedo, region.
const std::vector<std::string>& layer_names();
/// Names for RenderSettings::view that need no module: normal, depth, albedo, region.
const std::vector<std::string>& view_names();

/// A camera that sees the whole box. It stands, from the box's centre, in the direction of azimuth and elevation
/// (degrees) as in BRL-CAD: azimuth 0 on +x, 90 on +y, elevation 90 above. fov_deg is the vertical angle. An empty or
/// unbounded box counts as the cube from -1 to 1.
CameraSettings fitted_camera(const Box3d& bounds, double azimuth_deg, double elevation_deg, double fov_deg,
                             double aspect);
/// The automatic view of BRL-CAD's rt, in the same direction: parallel rays, `width` across, which 0 makes the diagonal
/// of the box after it is rounded outward to whole units, from 1.414 times half of that off its centre (rt/do.c,
/// do_ae()).
CameraSettings automatic_view(const Box3d& bounds, double azimuth_deg, double elevation_deg, double width);

/// Renders all tiles, in Morton order, on all OpenMP threads; the same picture bit for bit for any number of them,
/// unless time_s ends it. When progress says interrupted, returns what there is: each pixel the mean of its samples,
/// black where it has none. Throws Error(usage) for a bad size, crop, layer or view, Error(bad_input) for a bad camera,
/// Error(limit) before anything is allocated where memory does not suffice.
RenderResult render(const CommittedScene& scene, const LightingModule& lighting, const RenderSettings& settings,
                    Progress& progress);

}  // namespace cardioid
