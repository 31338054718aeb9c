#pragma once
#include "shaders/lights/lat_long.hpp"

namespace cardioid::shaders {

/// The CIE standard general sky (ISO 15469:2004, CIE S 011): how bright a sky of one of fifteen types is in a
/// direction, against its zenith. Directions are the sky's own, with the zenith at +z and the sun above +x; below the
/// horizon it is black. The sun's disc is no part of it.
class CieSky {
public:
    /// type: 1 to 15; elevation: the sun's over the horizon [rad], 0 to pi / 2.
    CieSky(int type, double elevation);

    /// Luminance over that of the zenith, d of any length above 0.
    [[nodiscard]] double relative(Vec3d d) const noexcept;
    /// Integral of relative() over all directions [sr].
    [[nodiscard]] double integral() const noexcept { return integral_; }
    [[nodiscard]] const LatLongDensity& density() const noexcept { return density_; }

private:
    [[nodiscard]] double gradation(double cos_zenith) const noexcept;
    [[nodiscard]] double indicatrix(double cos_sun) const noexcept;

    double a_, b_, c_, d_, e_;  ///< of the standard's table 1
    Vec3d sun_;
    double zenith_ = 1;  ///< gradation times indicatrix there
    double integral_ = 0;
    LatLongDensity density_;
};

}  // namespace cardioid::shaders
