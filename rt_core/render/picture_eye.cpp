#include "rt_core/render/picture_eye.hpp"

#include <fmt/format.h>

namespace cardioid {

namespace {

Eye::Crop checked_crop(const RenderSettings& s) {
    if (s.width < 1 || s.height < 1)
        throw Error(ErrorCode::usage, fmt::format("a picture of {} x {} pixels has none", s.width, s.height));
    if (s.crop == std::array{0, 0, 0, 0}) return {0, 0, s.width, s.height};
    const auto [x0, y0, x1, y1] = s.crop;
    if (x0 < 0 || y0 < 0 || x1 > s.width || y1 > s.height || x0 >= x1 || y0 >= y1)
        throw Error(ErrorCode::usage, fmt::format("crop {},{},{},{} must be x0 < x1 <= {} and y0 < y1 <= {}", x0, y0,
                                                  x1, y1, s.width, s.height));
    return {x0, y0, x1, y1};
}

}  // namespace

PictureEye::PictureEye(const CommittedScene& scene, const RenderSettings& settings)
    : scene_(scene),
      width_(settings.width),
      height_(settings.height),
      crop_(checked_crop(settings)),
      camera_(settings.camera, settings.width, settings.height) {
    if (camera_.is_pinhole()) medium_ = scene.medium_at(camera_.eye());
}

EyeRay PictureEye::ray(Vec2d film, Vec2 u_lens) const noexcept {
    const Ray ray = camera_.ray(film, u_lens);
    const double pixel = camera_.footprint(0);
    return {ray, medium_ ? medium_ : scene_.medium_at(ray.o), pixel, camera_.footprint(1) - pixel};
}

void PictureEye::look(Vec2d film, Sampler& sampler, const std::function<void(const Sight&)>& see) const {
    look_along(scene_, ray(film, sampler.next2()), sampler, see);
}

}  // namespace cardioid
