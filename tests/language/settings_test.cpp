#include <gtest/gtest.h>

#include "tests/language/read.hpp"

using namespace cardioid;
using cardioid::test::contains;
using cardioid::test::error_of;
using cardioid::test::read;
using cardioid::test::warnings_of;

TEST(Film, SaysSizeSamplesAndExposure) {
    const FilmSettings film = read("film([640, 480], samples = 16, exposure = -1.5);").film;
    EXPECT_EQ(film.width, 640);
    EXPECT_EQ(film.height, 480);
    EXPECT_EQ(film.samples, 16);
    EXPECT_EQ(film.exposure, -1.5);
    EXPECT_FALSE(read("cube();").film.width);
}

TEST(Film, RefusesWhatIsNoPictureSize) {
    for (const char* film : {"film([0, 10]);", "film([1.5, 10]);", "film([10]);", "film([-1, 4]);", "film([1e12, 4]);",
                             "film([nan, 4]);", "film(samples = 0);", "film(exposure = inf);", "film(\"big\");"})
        EXPECT_TRUE(error_of(film).starts_with("t.csg:1:")) << film << error_of(film);
}

TEST(Camera, ReadsEveryParameter) {
    const Scene scene = read(
        "camera([1, 2, 3], look_at = [0, 0, 1], up = [0, 1, 0], fov = 30, fov_axis = \"x\", lens_radius = 0.5, focus = "
        "7, "
        "name = \"side\");");
    const CameraSettings& camera = scene.cameras.at(0);
    EXPECT_EQ(camera.eye, Vec3d(1, 2, 3));
    EXPECT_EQ(camera.look_at, Vec3d(0, 0, 1));
    EXPECT_EQ(camera.up, Vec3d(0, 1, 0));
    EXPECT_EQ(camera.fov_deg, 30);
    EXPECT_TRUE(camera.fov_is_horizontal);
    EXPECT_EQ(camera.lens_radius, 0.5);
    EXPECT_EQ(camera.focus, 7);
    EXPECT_EQ(camera.name, "side");
}

TEST(Camera, MovesWithTheTransformsAroundIt) {
    const Scene scene = read("translate([10, 0, 0]) scale(2) camera([1, 0, 0], look_at = [0, 0, 0], focus = 3);");
    EXPECT_EQ(scene.cameras[0].eye, Vec3d(12, 0, 0));
    EXPECT_EQ(scene.cameras[0].look_at, Vec3d(10, 0, 0));
    EXPECT_NEAR(scene.cameras[0].focus, 6, 1e-12);
}

TEST(Camera, OrthographicWantsAWidth) {
    EXPECT_EQ(read("camera([0, 0, 9], projection = \"orthographic\", width = 12);").cameras[0].width, 12);
    EXPECT_TRUE(contains(error_of("camera([0, 0, 9], projection = \"orthographic\");"), "width of camera()"));
    EXPECT_TRUE(
        contains(error_of("camera([0, 0, 9], projection = \"ortographic\");"), "did you mean \"orthographic\"?"));
}

TEST(Camera, RefusesWhatCannotBeLookedThrough) {
    for (const char* camera : {"camera([0, 1, 0], look_at = [0, 1, 0]);", "camera([1, 2]);", "camera([0, 0, nan]);",
                               "camera([0, 0, 9], fov = 0);", "camera([0, 0, 9], fov = 180);",
                               "camera([0, 0, 9], up = [0, 0, 0]);", "camera([0, 0, 9], fov_axis = \"z\");",
                               "scale([1, 1, 0]) camera([0, 0, 9]);", "camera([0, 0, 9], lens_radius = -1);"})
        EXPECT_TRUE(error_of(camera).starts_with("t.csg:1:")) << camera << error_of(camera);
}

TEST(Lights, KeepTheirPlaceAndParameters) {
    const Scene scene = read("translate([1, 2, 3]) area_light([4, 5], radiance = 7);");
    ASSERT_EQ(scene.lights.size(), 1U);
    EXPECT_EQ(scene.lights[0].kind, "area_light");
    EXPECT_EQ(scene.lights[0].to_world.t, Vec3d(1, 2, 3));
    EXPECT_EQ(*scene.lights[0].params.vector("size", 2), (std::vector<double>{4, 5}))
        << "unnamed arguments fill in order";
    EXPECT_EQ(scene.lights[0].params.number("radiance", 0), 7);
}

TEST(Lights, UnknownParametersAreWarnings) {
    EXPECT_EQ(warnings_of(read("area_light([1, 1], radianse = 3);")),
              "t.csg:1:20: area_light() has no parameter \"radianse\" (did you mean \"radiance\"?): ignored\n");
}

TEST(Lights, ParametersOfTheWrongTypeNameTheirPlace) {
    const Scene scene = read("cube();\n area_light([1, 1], radiance = \"much\");");
    try {
        static_cast<void>(scene.lights[0].params.colour("radiance", {}));
        FAIL();
    } catch (const Error& e) {
        EXPECT_TRUE(std::string(e.what()).starts_with("t.csg:2:2: radiance must be")) << e.what();
    }
    EXPECT_TRUE(contains(error_of("area_light([[1], 1]);"), "size of area_light() must be a number"));
}

TEST(Photons, KeepTheirParameters) {
    const Scene scene = read("photons(count = 1000, mode = \"report\", fast = true);");
    EXPECT_EQ(scene.photons.number("count", 0), 1000);
    EXPECT_EQ(scene.photons.text("mode"), "report");
    EXPECT_TRUE(scene.photons.boolean("fast", false));
}
