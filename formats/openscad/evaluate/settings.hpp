#pragma once
#include "formats/openscad/evaluate/materials.hpp"
#include "rt_core/scene/scene.hpp"

namespace cardioid::formats::openscad {

/// The light kind of that name in the registry, or null.
const LightKind* find_light(const Registry* registry, std::string_view name);

/// film([W, H], samples = N, exposure = EV). Throws Error(bad_input) for what is no picture size.
FilmSettings read_film(const Arguments& arguments);

/// camera(...) placed by the transforms around it. Throws Error(bad_input).
CameraSettings read_camera(const Arguments& arguments, const Affine& to_world, Warnings& warnings);

/// A light placed by the transforms around it; unknown parameters are warnings. Throws Error(bad_input).
LightSettings read_light(const LightKind& kind, const Ast& ast, const Call& call, const Affine& to_world,
                         Warnings& warnings);

/// photons(...): parameters of the photon module are its own, taken as they stand.
Params read_photons(const Ast& ast, const Call& call);

/// map_color([r, g, b, a], "material").
void map_colour(const Arguments& arguments, MaterialTable& materials);

}  // namespace cardioid::formats::openscad
