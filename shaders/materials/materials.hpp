#pragma once
#include "rt_core/api/shader.hpp"

/// The kinds of material, each defined in the file of its name; builtins.cpp lists them.
namespace cardioid::shaders {

extern const ShaderKind checker_kind;
extern const ShaderKind conductor_kind;
extern const ShaderKind dielectric_kind;
extern const ShaderKind diffuse_kind;
extern const ShaderKind emitter_kind;
extern const ShaderKind filter_kind;
extern const ShaderKind mirror_kind;
extern const ShaderKind phong_kind;
extern const ShaderKind plastic_kind;
extern const ShaderKind pov_finish_kind;

}  // namespace cardioid::shaders
