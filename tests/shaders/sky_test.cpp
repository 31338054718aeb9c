#include <OpenImageIO/imageio.h>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

#include "make.hpp"
#include "statistics.hpp"

#include "shaders/lights/lat_long.hpp"

namespace cardioid::test {
namespace {

/// A folder that is gone after the test.
class SkyPicture : public testing::Test {
protected:
    void SetUp() override {
        folder_ = std::filesystem::temp_directory_path() /
                  ("cardioid_sky_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    void write(const std::string& name, int width, int height, int channels, const std::vector<float>& pixels) const {
        const std::string path = (folder_ / name).string();
        const auto out = OIIO::ImageOutput::create(path);
        ASSERT_TRUE(out);
        const bool floats = name.ends_with(".exr");
        ASSERT_TRUE(out->open(path, {width, height, channels, floats ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8}));
        ASSERT_TRUE(out->write_image(OIIO::TypeDesc::FLOAT, pixels.data()));
        ASSERT_TRUE(out->close());
    }
    std::unique_ptr<Light> sky(const std::string& file, Values values = {}) const {
        values["file"] = text(file);
        return make_light("sky", values, {}, folder_.string());
    }

    std::filesystem::path folder_;
};

/// Dark with a bright spot, all channels different.
std::vector<float> spotted(int width, int height) {
    std::vector<float> pixels;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const bool bright = x >= 3 && x < 6 && y >= 4 && y < 6;
            const float v = bright ? 40.0F : 0.2F + 0.1F * static_cast<float>((x + y) % 3);
            pixels.insert(pixels.end(), {v, v / 2, v / 4});
        }
    return pixels;
}

TEST_F(SkyPicture, IsSampledByItsBrightness) {
    write("sky.exr", 32, 16, 3, spotted(32, 16));
    const auto light = sky("sky.exr", {{"rotation", number(77)}});
    const Draw draw = [&](Random& random) { return light->sample({}, random.next2()).wi; };
    const Density density = [&](Vec3 wi) { return double{light->pdf({}, wi)}; };
    expect_density(draw, density, {}, 400'000);
    EXPECT_NEAR(DirectionTest(draw, density, 0).integral(), 1, 2e-3);
    Random random;
    for (int i = 0; i < 1000; ++i) {
        const LightSample s = light->sample({}, random.next2());
        EXPECT_NEAR(light->pdf({}, s.wi), s.pdf, 1e-4F * s.pdf) << i;
        EXPECT_NEAR(light->escaped(s.wi).r, s.L.r, 1e-3F * s.L.r);
    }
}

TEST_F(SkyPicture, BringsItsPowerByPhotons) {
    write("sky.exr", 32, 16, 3, spotted(32, 16));
    const auto light = sky("sky.exr");
    light->prepare({}, 2);
    double sum = 0;
    constexpr std::uint32_t n = 1 << 17;
    for (std::uint32_t i = 0; i < n; ++i) {
        Sampler sampler(1, Purpose::test, 0, i);
        const Vec2 u = sampler.next2();
        sum += double{light->emit(u, sampler.next2()).flux.g};
    }
    EXPECT_NEAR(sum / n, double{light->power().g}, 3e-3 * double{light->power().g});
}

TEST_F(SkyPicture, HasUpAtItsTopAndTheRightOnTheRight) {
    std::vector<float> pixels(8 * 4 * 3, 0.0F);
    const auto set = [&](int x, int y, float v) { pixels[static_cast<std::size_t>((y * 8 + x) * 3)] = v; };
    for (int x = 0; x < 8; ++x) set(x, 0, 1);                              // top row
    for (int y = 1; y < 3; ++y) set(3, y, 2), set(4, y, 2), set(6, y, 5);  // middle, and right of it
    write("sky.exr", 8, 4, 3, pixels);
    const auto light = sky("sky.exr");
    EXPECT_NEAR(light->escaped({0, 0, 1}).r, 1, 1e-5F);
    EXPECT_NEAR(light->escaped({0, 0, -1}).r, 0, 1e-5F);
    EXPECT_NEAR(light->escaped({1, 0, 0}).r, 2, 1e-5F);
    // Who looks along +x has -y on the right; column 6.5 of 8 is 3/4 of the half turn.
    const float a = -2 * pi * (6.5F / 8 - 0.5F);
    EXPECT_NEAR(light->escaped({std::cos(a), std::sin(a), 0}).r, 5, 1e-4F);
    const auto turned = sky("sky.exr", {{"rotation", number(90)}});
    EXPECT_NEAR(turned->escaped({0, 1, 0}).r, 2, 1e-5F);
}

TEST_F(SkyPicture, OfEightBitsIsDecodedAndScaled) {
    write("sky.png", 4, 2, 3, std::vector<float>(4 * 2 * 3, 128 / 255.0F));
    EXPECT_NEAR(sky("sky.png")->escaped({0, 1, 0}).r, 0.2159F, 1e-3F);
    EXPECT_NEAR(sky("sky.png", {{"radiance", number(3)}})->escaped({0, 1, 0}).g, 3 * 0.2159F, 3e-3F);
}

TEST_F(SkyPicture, MayBeGreyAndMayHoldRubbish) {
    const float nan = std::nanf("");
    write("grey.exr", 4, 2, 1, {1, nan, -3, 2, 1, INFINITY, 0, 0});
    const auto light = sky("grey.exr");
    light->prepare({}, 1);
    EXPECT_TRUE(is_finite(light->power()));
    Random random;
    for (int i = 0; i < 1000; ++i) {
        const LightSample s = light->sample({}, random.next2());
        EXPECT_TRUE(is_finite(s.L) && s.pdf > 0 && s.L.r == s.L.b);
    }
}

TEST_F(SkyPicture, ThatIsBlackGivesNothing) {
    write("black.exr", 4, 2, 3, std::vector<float>(24, 0.0F));
    const auto light = sky("black.exr");
    light->prepare({}, 1);
    EXPECT_TRUE(is_black(light->sample({}, {0.5F, 0.5F}).L));
    EXPECT_EQ(light->pdf({}, {0, 0, 1}), 0);
    EXPECT_TRUE(is_black(light->emit({0.5F, 0.5F}, {0.5F, 0.5F}).flux));
}

TEST_F(SkyPicture, ThatCannotBeReadIsAnInputOutputError) {
    std::ofstream(folder_ / "broken.exr") << "no picture";
    for (const char* file : {"missing.exr", "broken.exr"}) {
        try {
            sky(file);
            ADD_FAILURE() << file;
        } catch (const Error& e) {
            EXPECT_EQ(e.code(), ErrorCode::io);
            EXPECT_NE(std::string(e.what()).find("scene.csg:3:7"), std::string::npos);
            EXPECT_NE(std::string(e.what()).find(file), std::string::npos);
        }
    }
}

TEST(LatLongDensity, NeverDrawsACellOfNoWeight) {
    const shaders::LatLongDensity density(4, 2, {0, 1, 0, 0, 0, 0, 0, 3});
    constexpr float edge = 0x1.fffffep-1F;
    for (const float x : {0.0F, 0.2F, 0.5F, edge})
        for (const float y : {0.0F, 0.2F, 0.25F, 0.5F, edge}) {
            const auto drawn = density.sample({x, y});
            EXPECT_GT(drawn.pdf, 0);
            EXPECT_TRUE(is_finite(drawn.d));
        }
}

TEST(Studio, IsBrightestOverheadWithABackdropOfItsOwn) {
    const auto light = make_light("sky", {{"radiance", text("studio")}});
    const auto at = [&](Vec3 d) { return light->escaped(d); };
    EXPECT_GT(at({0, 0, 1}).r, at({1, 0, 0}).r);
    EXPECT_GT(at({0, 1, 0}).r, at({0, 0, -1}).r);
    EXPECT_GT(at({0, 0, -1}).r, 0);
    EXPECT_EQ(at({0, 0, 1}).r, at({0, 0, 1}).b);
    EXPECT_GT(light->backdrop({0, 1, 0}).r, 2 * at({0, 1, 0}).r);
    EXPECT_LT(light->backdrop({0, 0, 1}).r, 1);
}

}  // namespace
}  // namespace cardioid::test
