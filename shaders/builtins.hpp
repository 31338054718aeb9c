#pragma once
#include <span>

#include "rt_core/api/light.hpp"
#include "rt_core/api/registry.hpp"
#include "rt_core/api/shader.hpp"

namespace cardioid::shaders {

/// Every material that comes with the program, in the order `cardioid list` prints them.
std::span<const ShaderKind> builtin_shaders();
/// Every light that comes with the program.
std::span<const LightKind> builtin_lights();
/// Both, into a registry.
void add_builtins(Registry& registry);

}  // namespace cardioid::shaders
