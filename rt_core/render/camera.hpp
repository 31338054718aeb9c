#pragma once
#include "rt_core/api/surface.hpp"
#include "rt_core/scene/scene.hpp"

namespace cardioid {

/// Turns places on the picture into rays: pinhole, thin lens, or orthographic.
class Camera {
public:
    /// Throws Error(bad_input) where eye and look_at coincide, something is not finite, or fov or width is out of
    /// range.
    Camera(const CameraSettings& settings, int width, int height);

    /// The ray through `film` (pixels; (0, 0) is the top left corner of the picture, centres lie at +0.5), u_lens in
    /// [0,1)^2.
    [[nodiscard]] Ray ray(Vec2d film, Vec2 u_lens) const noexcept;
    /// Width of a pixel, in scene units, at a distance from the eye.
    [[nodiscard]] double footprint(double distance) const noexcept { return pixel_ + spread_ * distance; }
    [[nodiscard]] Vec3d eye() const noexcept { return eye_; }
    /// Whether all rays start at eye().
    [[nodiscard]] bool is_pinhole() const noexcept { return !orthographic_ && lens_radius_ == 0; }

private:
    Vec3d eye_, forward_, right_, up_;
    Vec2d half_, resolution_;  ///< half the picture at distance 1 (or in units); pixels
    bool orthographic_;
    double lens_radius_, focus_;
    Vec2d shift_;  ///< of every place on the film [pixels]
    double pixel_ = 0, spread_ = 0;
};

}  // namespace cardioid
