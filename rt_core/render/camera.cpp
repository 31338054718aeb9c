#include "rt_core/render/camera.hpp"

#include <algorithm>
#include <numbers>

#include "rt_core/render/renderer.hpp"

namespace cardioid {

namespace {

constexpr double degree = std::numbers::pi / 180;
/// Share of the picture that the box takes in a fitted view.
constexpr double fitted_share = 0.94;
/// Sine of the angle between up and the view below which up says nothing.
constexpr double smallest_up = 1e-6;
/// What a camera may stand or reach away: Embree takes origins of rays up to 1.8e18.
constexpr double farthest_coordinate = 1e15;

[[noreturn]] void fail(const CameraSettings& camera, const std::string& what) {
    throw Error(ErrorCode::bad_input, "camera \"" + camera.name + "\": " + what);
}

/// To the right of the picture. Looking straight up or down, +y (then x) takes the place of an up that says nothing.
Vec3d right_of(Vec3d forward, Vec3d up) {
    for (const Vec3d candidate : {up, Vec3d{0, 1, 0}, Vec3d{1, 0, 0}}) {
        const Vec3d right = cross(forward, candidate);
        if (length(right) > smallest_up * length(candidate)) return normalize(right);
    }
    return {1, 0, 0};
}

void check(const CameraSettings& camera) {
    for (const Vec3d v : {camera.eye, camera.look_at, camera.up})
        if (!is_finite(v)) fail(camera, "a coordinate is not finite");
    const double farthest = std::max({max_component(abs(camera.eye)), max_component(abs(camera.look_at)),
                                      camera.lens_radius, camera.focus, camera.width});
    if (farthest > farthest_coordinate) fail(camera, "a coordinate or length is beyond 1e15");
    if (!(length(camera.look_at - camera.eye) > 0)) fail(camera, "eye and look_at are the same point");
    if (camera.projection == CameraSettings::Projection::orthographic) {
        if (!(camera.width > 0) || !std::isfinite(camera.width)) fail(camera, "width must be above 0");
    } else if (!(camera.fov_deg > 0 && camera.fov_deg < 180)) {
        fail(camera, "fov must be between 0 and 180 degrees");
    }
    if (!(camera.lens_radius >= 0) || !std::isfinite(camera.lens_radius))
        fail(camera, "lens_radius must be at least 0");
    if (!(camera.focus >= 0) || !std::isfinite(camera.focus)) fail(camera, "focus must be at least 0");
}

}  // namespace

Camera::Camera(const CameraSettings& settings, int width, int height)
    : eye_(settings.eye),
      resolution_(width, height),
      orthographic_(settings.projection == CameraSettings::Projection::orthographic),
      lens_radius_(settings.lens_radius),
      focus_(settings.focus),
      shift_(settings.pixel_shift) {
    check(settings);
    const Vec3d view = settings.look_at - settings.eye;
    if (focus_ == 0) focus_ = length(view);
    forward_ = normalize(view);
    right_ = right_of(forward_, settings.up);
    up_ = cross(right_, forward_);
    const double aspect = resolution_.x / resolution_.y;
    if (orthographic_) {
        half_ = {settings.width / 2, settings.width / 2 / aspect};
        pixel_ = settings.width / resolution_.x;
    } else {
        const double tangent = std::tan(settings.fov_deg / 2 * degree);
        half_ = settings.fov_is_horizontal ? Vec2d{tangent, tangent / aspect} : Vec2d{tangent * aspect, tangent};
        spread_ = 2 * half_.x / resolution_.x;
    }
}

Ray Camera::ray(Vec2d film, Vec2 u_lens) const noexcept {
    const double x = (2 * (film.x + shift_.x) / resolution_.x - 1) * half_.x;
    const double y = (1 - 2 * (film.y + shift_.y) / resolution_.y) * half_.y;
    const Vec3d aside = right_ * x + up_ * y;
    Ray ray;
    if (orthographic_) {
        ray.o = eye_ + aside;
        ray.d = forward_;
        return ray;
    }
    ray.o = eye_;
    Vec3d towards = forward_ + aside;
    if (lens_radius_ > 0) {
        const Vec2d lens(sample_disc(u_lens));
        const Vec3d on_lens = (right_ * lens.x + up_ * lens.y) * lens_radius_;
        ray.o += on_lens;
        towards = towards * focus_ - on_lens;
    }
    ray.d = normalize(towards);
    return ray;
}

namespace {

/// What a fitted camera looks at, and from where.
struct Direction {
    Direction(double azimuth_deg, double elevation_deg) {
        const double a = azimuth_deg * degree, e = elevation_deg * degree;
        back = {std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)};
        // Straight from above or below, the azimuth alone tells what is up.
        level = {-std::sin(a), std::cos(a), 0};
        up = cross(back, level);
    }
    Vec3d back, level, up;
};

Box3d box_to_fit(const Box3d& bounds) {
    return !bounds.empty() && bounds.bounded() ? bounds : Box3d{{-1, -1, -1}, {1, 1, 1}};
}

/// A single point has no size to stand back from.
double size_around(const Box3d& box) { return std::max(max_component(abs(box.centre())), 1.0); }

}  // namespace

CameraSettings fitted_camera(const Box3d& bounds, double azimuth_deg, double elevation_deg, double fov_deg,
                             double aspect) {
    const Box3d box = box_to_fit(bounds);
    const Direction from(azimuth_deg, elevation_deg);
    const double tan_y = std::tan(fov_deg / 2 * degree) * fitted_share;
    const double tan_x = tan_y * aspect;
    double distance = 0;
    for (int i = 0; i < 8; ++i) {
        const Vec3d corner{i & 1 ? box.hi.x : box.lo.x, i & 2 ? box.hi.y : box.lo.y, i & 4 ? box.hi.z : box.lo.z};
        const Vec3d c = corner - box.centre();
        const double x = std::abs(dot(c, from.level)), y = std::abs(dot(c, from.up));
        distance = std::max(distance, dot(c, from.back) + std::max(x / tan_x, y / tan_y));
    }
    if (!(distance > 0)) distance = size_around(box);
    CameraSettings camera;
    camera.look_at = box.centre();
    camera.up = from.up;
    camera.fov_deg = fov_deg;
    camera.eye = camera.look_at + from.back * distance;
    return camera;
}

CameraSettings automatic_view(const Box3d& bounds, double azimuth_deg, double elevation_deg, double width) {
    constexpr double eye_backoff = 1.414;
    const Box3d fitted = box_to_fit(bounds);
    Box3d box;
    for (int axis = 0; axis < 3; ++axis)
        box.lo[axis] = std::floor(fitted.lo[axis]), box.hi[axis] = std::ceil(fitted.hi[axis]);
    const Direction from(azimuth_deg, elevation_deg);
    CameraSettings camera;
    camera.projection = CameraSettings::Projection::orthographic;
    camera.width = width > 0 ? width : box.diagonal();
    if (!(camera.width > 0)) camera.width = size_around(box);
    camera.look_at = box.centre();
    camera.up = from.up;
    camera.eye = camera.look_at + from.back * (eye_backoff * camera.width / 2);
    return camera;
}

}  // namespace cardioid
