#pragma once
#include "rt_core/api/lighting.hpp"

namespace cardioid::formats {

/// `--lighting rt`: the full lighting model of BRL-CAD's rt (-l0): light without fall-off from the middles of regions
/// whose shader is `light`, ambient light from the eye, Phong's highlight in Schlick's form (Schlick 1994, "A fast
/// alternative to Phong's specular model"), mirrors and glass by fixed shares. Pictures have rt's own numbers, which a
/// display shows as they are. Only materials of the kind `rt_surface` are lit.
extern const LightingKind rt_lighting;

}  // namespace cardioid::formats
