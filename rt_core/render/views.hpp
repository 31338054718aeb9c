#pragma once
#include <string>

#include "rt_core/render/camera_path.hpp"

namespace cardioid {

/// A debug picture: shows one property of the surface that the eye meets first.
class View {
public:
    /// name: of view_names() or one of the module's views. Throws Error(usage) with the nearest name otherwise.
    View(const std::string& name, const CommittedScene& scene, const LightingModule& module);
    /// The colour of a sample, linear; black where the ray meets nothing. Normals are shown as (n + 1) / 2, depth as
    /// white at the near and black at the far end of the scene.
    [[nodiscard]] Rgb colour(const EyeRay& camera) const noexcept;

private:
    enum class Kind { normal, depth, albedo, region, module };
    [[nodiscard]] Rgb depth_grey(const EyeRay& camera, double distance) const noexcept;

    const CommittedScene& scene_;
    const LightingModule& module_;
    std::string name_;
    Kind kind_ = Kind::module;
};

/// A colour that tells neighbouring ids apart, always the same for an id.
Rgb false_colour(std::uint32_t id) noexcept;

}  // namespace cardioid
