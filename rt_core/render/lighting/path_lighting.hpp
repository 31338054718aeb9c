#pragma once
#include "rt_core/api/lighting.hpp"

namespace cardioid {

/// `path`: the truth, slowly. Every way of light there is, without bias and without a limit but `depth`; what all other
/// modules are measured by.
extern const LightingKind path_lighting;

}  // namespace cardioid
