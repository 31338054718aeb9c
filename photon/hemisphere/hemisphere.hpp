#pragma once
#include <span>

#include "rt_core/api/math.hpp"

namespace cardioid::photon {

/// How the hemisphere is divided along its elevation (ARL-TR-3608, note [7]).
enum class HemisphereCells {
    cosine,             ///< all cells of equal cosine-weighted area: the plain mean of their light is right
    equal_angle,        ///< of equal elevation; the report's template, wrong for anything but even light
    equal_solid_angle,  ///< the same
};

/// The rays of one final gather: one in each cell of rings and sectors (the report's template is 6 x 13).
struct Hemisphere {
    int rings = 9;     ///< M
    int sectors = 28;  ///< N; about pi M makes the cells as wide as high (Ward, Heckbert 1992)
    HemisphereCells cells = HemisphereCells::cosine;
    /// Where within a cell the ray may go: (1 - jitter) + jitter u of it; 1 all of it, 0.5 the report's outer quarter.
    float jitter = 1;

    /// Cosine cells for at least so many rays, at least 2 rings.
    [[nodiscard]] static Hemisphere of(int rays) noexcept;
    [[nodiscard]] int size() const noexcept { return rings * sectors; }
    /// Unit direction about +z of the ray in ring j and sector k; u in [0,1)^2.
    [[nodiscard]] Vec3 direction(int j, int k, Vec2 u) const noexcept;
};

/// What a ray of the hemisphere found.
struct HemisphereRay {
    Rgb L;               ///< radiance [W/(sr unit^2)]
    float distance = 0;  ///< > 0, infinite where it left the scene
    Vec3 d{};            ///< where it went, unit, about +z
};

/// A derivative of irradiance, one vector a channel, in the world.
struct Gradient {
    Vec3 r, g, b;
    /// Change along v.
    [[nodiscard]] Rgb along(Vec3 v) const noexcept { return {dot(r, v), dot(g, v), dot(b, v)}; }
};

/// Irradiance of a point and how it changes around it.
struct HemisphereReading {
    Rgb E;                        ///< pi mean L [W/unit^2]
    Gradient rotational;          ///< per radian: turning the normal about the axis a changes E by along(a)
    Gradient translational;       ///< per scene unit
    float harmonic_distance = 0;  ///< harmonic mean of the rays' lengths, infinite where none met anything
    float error = 0;  ///< estimated standard error of the luminance of E, from differences of neighbouring cells
};

/// Sums up the rays, ring by ring: ray (j, k) is rays[j * sectors + k]. `frame` turns local directions into the world.
/// Gradients after Ward, Heckbert 1992, "Irradiance Gradients", with the mean of the tangent over each ring in place
/// of its value in the middle, which loses a tenth; they need cosine cells and are zero with others.
[[nodiscard]] HemisphereReading read_hemisphere(const Hemisphere& hemisphere, const Frame& frame,
                                                std::span<const HemisphereRay> rays) noexcept;

}  // namespace cardioid::photon
