#pragma once
#include "rt_core/api/format.hpp"

namespace cardioid::formats {

/// `.pov`: the twin of a scene for POV-Ray 3.7; written only.
extern const Format pov_format;

}  // namespace cardioid::formats
