#pragma once
#include "rt_core/api/light.hpp"

/// The kinds of light, each defined in the file of its name; builtins.cpp lists them.
namespace cardioid::shaders {

extern const LightKind area_light_kind;
extern const LightKind disk_light_kind;
extern const LightKind point_light_kind;
extern const LightKind sky_kind;
extern const LightKind sphere_light_kind;
extern const LightKind spot_light_kind;
extern const LightKind sun_kind;

}  // namespace cardioid::shaders
