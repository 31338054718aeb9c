#pragma once

namespace cardioid::csg {

struct SinCos {
    double sin, cos;
};

/// Sine and cosine of a finite angle in degrees; exact (to the last bit of 1/2, sqrt(1/2), sqrt(3)/2) at multiples of
/// 30 and 45, and exactly symmetric in all octants.
SinCos sin_cos_deg(double degrees);

}  // namespace cardioid::csg
