#include "rt_core/render/camera.hpp"

#include <gtest/gtest.h>

#include "rt_core/render/renderer.hpp"

namespace cardioid {
namespace {

CameraSettings looking_along_y() {
    CameraSettings camera;
    camera.eye = {1, 2, 3};
    camera.look_at = {1, 12, 3};
    camera.fov_deg = 90;
    return camera;
}

void expect_along(Vec3d d, Vec3d wanted) {
    EXPECT_LT(length(d - normalize(wanted)), 1e-12) << d.x << ' ' << d.y << ' ' << d.z;
}

TEST(Camera, HasItsFirstPixelTopLeftAndItsAngleVertical) {
    const Camera camera(looking_along_y(), 200, 100);
    expect_along(camera.ray({0, 0}, {}).d, {-2, 1, 1});
    expect_along(camera.ray({200, 0}, {}).d, {2, 1, 1});
    expect_along(camera.ray({0, 100}, {}).d, {-2, 1, -1});
    expect_along(camera.ray({100, 50}, {}).d, {0, 1, 0});
    EXPECT_EQ(camera.ray({0, 0}, {}).o, (Vec3d{1, 2, 3}));
}

TEST(Camera, MayMeasureItsAngleAcross) {
    CameraSettings settings = looking_along_y();
    settings.fov_is_horizontal = true;
    const Camera camera(settings, 200, 100);
    expect_along(camera.ray({0, 0}, {}).d, {-1, 1, 0.5});
}

TEST(Camera, LooksStraightDownWithAnUpThatSaysNothing) {
    CameraSettings settings;
    settings.eye = {0, 0, 5};
    settings.look_at = {0, 0, 0};
    settings.fov_deg = 90;
    const Camera camera(settings, 100, 100);
    expect_along(camera.ray({50, 0}, {}).d, {0, 1, -1});
    expect_along(camera.ray({100, 50}, {}).d, {1, 0, -1});
}

TEST(Camera, SendsParallelRaysWhereOrthographic) {
    CameraSettings settings = looking_along_y();
    settings.projection = CameraSettings::Projection::orthographic;
    settings.width = 8;
    const Camera camera(settings, 200, 100);
    EXPECT_LT(length(camera.ray({0, 0}, {}).o - Vec3d{1 - 4, 2, 3 + 2}), 1e-12);
    expect_along(camera.ray({0, 0}, {}).d, {0, 1, 0});
    EXPECT_DOUBLE_EQ(camera.footprint(7), 0.04);
}

TEST(Camera, FocusesEveryPointOfItsLensOnOnePlane) {
    CameraSettings settings = looking_along_y();
    settings.lens_radius = 0.5;
    settings.focus = 4;
    const Camera camera(settings, 200, 100);
    const Vec3d wanted = Vec3d{1, 2, 3} + Vec3d{-2, 1, 1} * 4.0;
    double farthest = 0;
    for (int i = 0; i < 64; ++i) {
        const Ray ray = camera.ray({0, 0}, {static_cast<float>(i % 8) / 8, static_cast<float>(i / 8) / 8});
        const double t = 4 / ray.d.y;
        EXPECT_LT(length(ray.o + ray.d * t - wanted), 1e-6);
        farthest = std::max(farthest, length(ray.o - Vec3d{1, 2, 3}));
    }
    EXPECT_LE(farthest, 0.5 + 1e-6);
    EXPECT_GT(farthest, 0.4);
}

TEST(Camera, RefusesWhatCannotBeSeenThrough) {
    const auto refused = [](auto&& change) {
        CameraSettings settings = looking_along_y();
        change(settings);
        EXPECT_THROW(Camera(settings, 10, 10), Error);
    };
    refused([](CameraSettings& c) { c.look_at = c.eye; });
    refused([](CameraSettings& c) { c.fov_deg = 180; });
    refused([](CameraSettings& c) { c.fov_deg = 0; });
    refused([](CameraSettings& c) { c.eye.x = std::nan(""); });
    refused([](CameraSettings& c) { c.eye.x = 1e300; });
    refused([](CameraSettings& c) { c.lens_radius = c.focus = 1e300; });
    refused([](CameraSettings& c) { c.lens_radius = -1; });
    refused([](CameraSettings& c) { c.projection = CameraSettings::Projection::orthographic; });
}

/// Where on the picture, in [-1, 1] both ways, the camera shows p.
Vec2d shown(const CameraSettings& settings, double aspect, Vec3d p) {
    const Vec3d forward = normalize(settings.look_at - settings.eye), right = normalize(cross(forward, settings.up));
    const Vec3d up = cross(right, forward), to = p - settings.eye;
    if (settings.projection == CameraSettings::Projection::orthographic)
        return {dot(to, right) / (settings.width / 2), dot(to, up) / (settings.width / 2 / aspect)};
    const double tangent = std::tan(settings.fov_deg / 2 * std::numbers::pi / 180) * dot(to, forward);
    return {dot(to, right) / (tangent * aspect), dot(to, up) / tangent};
}

TEST(FittedCamera, ShowsTheWholeBoxAndLittleElse) {
    for (const Box3d& box :
         {Box3d{{0, 0, 0}, {1, 1, 1}}, Box3d{{100, -50, 3}, {101, 60, 3.5}}, Box3d{{0, 0, 0}, {1e-4, 1e-4, 9}}})
        for (const double fov : {10.0, 40.0, 90.0})
            for (const double azimuth : {0.0, 35.0, 200.0})
                for (const double elevation : {-90.0, 0.0, 25.0, 90.0})
                    for (const double aspect : {0.5, 1.0, 2.0}) {
                        const CameraSettings camera = fitted_camera(box, azimuth, elevation, fov, aspect);
                        double most = 0;
                        for (int i = 0; i < 8; ++i) {
                            const Vec2d at = shown(camera, aspect,
                                                   {i & 1 ? box.hi.x : box.lo.x, i & 2 ? box.hi.y : box.lo.y,
                                                    i & 4 ? box.hi.z : box.lo.z});
                            most = std::max({most, std::abs(at.x), std::abs(at.y)});
                        }
                        EXPECT_LE(most, 0.95);
                        EXPECT_GE(most, 0.93);
                    }
}

TEST(FittedCamera, StandsWhereAzimuthAndElevationSay) {
    const Box3d box{{-1, -1, -1}, {1, 1, 1}};
    expect_along(normalize(fitted_camera(box, 0, 0, 40, 1).eye), {1, 0, 0});
    expect_along(normalize(fitted_camera(box, 90, 0, 40, 1).eye), {0, 1, 0});
    expect_along(normalize(fitted_camera(box, 0, 90, 40, 1).eye), {0, 0, 1});
    const Vec3d eye = fitted_camera(box, 35, 25, 40, 1).eye;
    EXPECT_GT(eye.x, eye.y);
    EXPECT_GT(eye.y, 0);
    EXPECT_GT(eye.z, 0);
}

TEST(FittedCamera, TakesBoxesThatAreNone) {
    for (const Box3d& box : {Box3d{}, Box3d::everything(), Box3d{{2, 2, 2}, {2, 2, 2}}}) {
        EXPECT_NO_THROW(Camera(fitted_camera(box, 35, 25, 40, 1), 10, 10));
        EXPECT_NO_THROW(Camera(automatic_view(box, 35, 25, 0), 10, 10));
    }
}

TEST(AutomaticView, IsAsWideAsTheDiagonalOfTheRoundedBox) {
    const Box3d box{{0.5, 0, -2}, {2.2, 3.5, 10}};  // [0, 3] x [0, 4] x [-2, 10]
    const CameraSettings camera = automatic_view(box, 0, 0, 0);
    EXPECT_EQ(camera.projection, CameraSettings::Projection::orthographic);
    EXPECT_DOUBLE_EQ(camera.width, 13);
    EXPECT_EQ(camera.look_at, (Vec3d{1.5, 2, 4}));
    EXPECT_LT(length(camera.eye - Vec3d{1.5 + 1.414 * 6.5, 2, 4}), 1e-12);
    EXPECT_DOUBLE_EQ(automatic_view(box, 0, 0, 5).width, 5);
}

}  // namespace
}  // namespace cardioid
