#pragma once
#include "photon/options/choices.hpp"

namespace cardioid::photon {

/// pi r^2 times the weight of a photon at distance t r, for t2 = t^2 in [0, 1]: its mean over the disc is 1.
/// Sum of flux times weight over pi r^2 is then an estimate without bias where light is even, as long as the photon
/// that sets r is left out. Formulas: box; Jensen 2001, eq. 7.10 (cone, k = 1); eq. 7.9 (Gauss) with alpha = 1.728309,
/// for the printed 0.918 makes it 0.531; Epanechnikov; Simpson's biweight.
[[nodiscard]] float kernel_weight(Kernel kernel, float t2) noexcept;

/// The cone of Jensen 2001, eq. 7.10, for any k >= 1.
[[nodiscard]] float cone_weight(float k, float t2) noexcept;

}  // namespace cardioid::photon
