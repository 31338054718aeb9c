#pragma once
#include <functional>

#include "rt_core/api/bsdf.hpp"

namespace cardioid {

/// A ray from the eye and what it takes to follow it.
struct EyeRay {
    Ray ray;
    const Medium* medium = nullptr;  ///< at its origin
    double pixel = 0, spread = 0;    ///< width of a pixel at the origin, and its growth per unit of distance
};

/// The picture about to be taken, for modules that place their work where the eye looks. Any thread may call it.
class Eye {
public:
    virtual ~Eye() = default;
    /// Size of the whole picture in pixels.
    [[nodiscard]] virtual int width() const noexcept = 0;
    [[nodiscard]] virtual int height() const noexcept = 0;
    /// The part of it that is drawn: x0 <= x < x1, y0 <= y < y1.
    struct Crop {
        int x0, y0, x1, y1;
    };
    [[nodiscard]] virtual Crop crop() const noexcept = 0;
    /// A point that scatters light by non-delta lobes, seen straight or by mirrors and glass.
    struct Sight {
        const SurfacePoint& point;
        const Bsdf& bsdf;
        Vec3 wo;         ///< world
        Rgb throughput;  ///< share of the light from here that reaches the picture
        int bounces;     ///< mirrors and glass between it and the eye
    };
    /// Follows the ray through `film` (pixels, as Camera::ray) and calls `see` at each such point on its way.
    virtual void look(Vec2d film, Sampler& sampler, const std::function<void(const Sight&)>& see) const = 0;
};

}  // namespace cardioid
