#pragma once
#include "rt_core/api/format.hpp"

namespace cardioid::formats {

/// Databases of BRL-CAD: `.g` of version 5, `.asc` of versions 4 and 5.
extern const Format brlcad_format;

}  // namespace cardioid::formats
