#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "rt_core/api/params.hpp"
#include "rt_core/scene/solid.hpp"

namespace cardioid {

/// Picture settings of a scene file; what is not given is decided by the command line.
struct FilmSettings {
    std::optional<int> width, height;
    std::optional<int> samples;  ///< a pixel
    double exposure = 0;         ///< EV: display values are scaled by 2^exposure
};

struct CameraSettings {
    enum class Projection { perspective, orthographic };
    std::string name = "main";
    Projection projection = Projection::perspective;
    Vec3d eye{0, 0, 0}, look_at{0, 1, 0}, up{0, 0, 1};
    double fov_deg = 40;  ///< vertical full angle unless fov_is_horizontal
    bool fov_is_horizontal = false;
    double width = 0;        ///< of an orthographic view, scene units
    double lens_radius = 0;  ///< scene units, 0 is a pinhole
    double focus = 0;        ///< distance of the plane in focus, 0 is |look_at - eye|
    Vec2d pixel_shift;       ///< added to every place on the film [pixels], to meet another program's rays
};

/// How the camera looks that is fitted to the model where neither the file nor the command line has one.
struct FittedView {
    double azimuth_deg = 35, elevation_deg = 25;  ///< as BRL-CAD's rt
    bool parallel = false;  ///< rt's automatic view, parallel rays; else in perspective, as near as the model allows
    double width = 0;       ///< of the parallel view, scene units; 0: the model's diagonal
    Vec2d pixel_shift;      ///< CameraSettings::pixel_shift
};

/// A material by name; `kind` names a Shader of the registry. Index 0 of Scene::materials is the default material.
struct MaterialSettings {
    std::string name;
    std::string kind;
    Params params;
};

/// A light; `kind` names a Light of the registry.
struct LightSettings {
    std::string kind;
    Params params;
    Affine to_world;
};

/// All that a scene file says: plain data, no file left open, nothing computed for rendering yet.
struct Scene {
    std::string file;      ///< as given, for messages
    std::string base_dir;  ///< where relative files are looked for
    FilmSettings film;
    std::vector<CameraSettings> cameras;
    FittedView fitted;  ///< where there is no camera
    std::vector<MaterialSettings> materials;
    std::vector<LightSettings> lights;
    Params photons;  ///< photons(...): parameters of the photon module
    SolidTree solids;
    /// Of each root of `solids`: the number of the statement at the top of the file that made it. Solids of one
    /// statement are meant to be one. Empty: each root stands for itself.
    std::vector<std::uint32_t> statements;
    std::vector<std::string> names;  ///< of the roots, where the file names them; else empty
    std::vector<std::string> tops;   ///< objects that may be asked for by name, where the file has such
    std::vector<std::pair<std::string, std::string>> facts;  ///< what the file tells of itself: a name and a text
    std::string lighting;    ///< lighting module the file's look needs; empty: what the command line says
    bool six_digits = true;  ///< numbers were printed with 6 digits, so nearly coincident faces are meant to coincide
    std::vector<std::string> warnings;  ///< file:line:column: text
};

}  // namespace cardioid
