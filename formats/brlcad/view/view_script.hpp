#pragma once
#include <optional>
#include <string>
#include <vector>

#include "rt_core/scene/scene.hpp"

namespace cardioid::formats::brlcad {

/// What a view script of rt says of one picture.
struct View {
    std::string name = "0";                    ///< what `start` says
    std::optional<double> size;                ///< of an orthographic picture across [mm]
    std::optional<Vec3d> eye, look_at;         ///< [mm]
    std::optional<std::array<Vec3d, 3>> axes;  ///< to the right, up, and towards the eye; unit length
    std::optional<Vec2d> angles_deg;           ///< azimuth and elevation, where `ae` gave the axes
    double perspective_deg = 0;                ///< horizontal angle of view; 0 is orthographic
    std::optional<int> width, height;          ///< pixels
    std::vector<std::string> warnings;
};

/// Reads `viewsize 100; eye_pt 1 2 3; ... end;` or the old form, sixteen and four bare numbers: a view for each `end`,
/// one at least. What is said stays for the pictures that follow. Commands that mean nothing to a still
/// picture are passed over. Throws Error(bad_input) with file:line:column.
std::vector<View> read_views(const std::string& text, const std::string& file);

/// Puts the views' cameras before those of the scene, and the first one's size into the film. A first view without an
/// eye is rt's automatic one where `ae` says how to look; else it gives no camera, and a warning where it says
/// something.
void apply_views(const std::vector<View>& views, Scene& scene);

/// Axes of a view from azimuth and elevation [degrees].
std::array<Vec3d, 3> axes_from(double azimuth_deg, double elevation_deg);

}  // namespace cardioid::formats::brlcad
