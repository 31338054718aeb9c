#pragma once
#include "rt_core/render/camera.hpp"
#include "rt_core/render/camera_path.hpp"
#include "rt_core/render/renderer.hpp"

namespace cardioid {

/// The camera of a render in its scene; both must outlive it.
class PictureEye final : public Eye {
public:
    /// Throws Error(usage) where the crop of the settings is empty or sticks out, Error(bad_input) as Camera does.
    PictureEye(const CommittedScene& scene, const RenderSettings& settings);
    [[nodiscard]] int width() const noexcept override { return width_; }
    [[nodiscard]] int height() const noexcept override { return height_; }
    [[nodiscard]] Crop crop() const noexcept override { return crop_; }
    void look(Vec2d film, Sampler& sampler, const std::function<void(const Sight&)>& see) const override;

    /// Whether u_lens matters.
    [[nodiscard]] bool has_lens() const noexcept { return !camera_.is_pinhole(); }
    /// The ray through `film`, u_lens in [0,1)^2.
    [[nodiscard]] EyeRay ray(Vec2d film, Vec2 u_lens) const noexcept;

private:
    const CommittedScene& scene_;
    int width_, height_;
    Crop crop_;
    Camera camera_;
    const Medium* medium_ = nullptr;  ///< around a pinhole camera
};

}  // namespace cardioid
