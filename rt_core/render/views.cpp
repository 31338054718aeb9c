#include "rt_core/render/views.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "rt_core/render/renderer.hpp"
#include "rt_core/scene/nearest_name.hpp"

namespace cardioid {

const std::vector<std::string>& view_names() {
    static const std::vector<std::string> names{"normal", "depth", "albedo", "region"};
    return names;
}

View::View(const std::string& name, const CommittedScene& scene, const LightingModule& module)
    : scene_(scene), module_(module), name_(name) {
    std::vector<std::string> names = view_names();
    const auto at = std::find(names.begin(), names.end(), name);
    if (at != names.end()) {
        kind_ = static_cast<Kind>(at - names.begin());
        return;
    }
    const std::vector<std::string> own = module.views();
    if (std::find(own.begin(), own.end(), name) != own.end()) return;
    names.insert(names.end(), own.begin(), own.end());
    const std::vector<std::string_view> views(names.begin(), names.end());
    throw Error(ErrorCode::usage,
                fmt::format("no view \"{}\"{}; there are {}", name, did_you_mean(name, views), fmt::join(names, ", ")));
}

Rgb View::depth_grey(const EyeRay& camera, double distance) const noexcept {
    const Box3d box = scene_.bounds();
    if (box.empty()) return {};
    const double middle = length(box.centre() - camera.ray.o), radius = box.diagonal() / 2;
    const double near = std::max(0.0, middle - radius), far = middle + radius;
    return Rgb(static_cast<float>(std::clamp((far - distance) / (far - near), 0.0, 1.0)));
}

Rgb View::colour(const EyeRay& camera) const noexcept {
    const auto first = first_hit(scene_, camera);
    if (!first) return {};
    const Vec3 n = first->point.frame.n;
    switch (kind_) {
        case Kind::normal:
            return {(n.x + 1) / 2, (n.y + 1) / 2, (n.z + 1) / 2};
        case Kind::depth:
            return depth_grey(camera, first->distance);
        case Kind::albedo:
            return first->albedo.total();
        case Kind::region:
            return false_colour(first->point.id.region);
        case Kind::module:
            return module_.view(name_, scene_, first->point);
    }
    return {};
}

Rgb false_colour(std::uint32_t id) noexcept {
    const std::uint64_t bits = mix64(id);
    const auto channel = [&](unsigned shift) { return 0.1F + 0.8F * static_cast<float>(bits >> shift & 255) / 255; };
    return {channel(0), channel(8), channel(16)};
}

}  // namespace cardioid
