#pragma once
#include <vector>

#include "formats/brlcad/database.hpp"
#include "rt_core/math/affine.hpp"

namespace cardioid::formats::brlcad {

/// The numbers of the UvChart of a solid that `place` puts into the world; {0} for kinds without one.
std::vector<double> chart_of(const Solid& solid, const Affine& place);

}  // namespace cardioid::formats::brlcad
