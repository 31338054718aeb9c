/// The long run: every value of the table within its tolerance, and pictures against what is known of them.
#include <gtest/gtest.h>

#include "rt_core/image/image_file.hpp"
#include "rt_core/render/renderer.hpp"
#include "tests/accuracy/lit_scene.hpp"
#include "tests/accuracy/verdict.hpp"

namespace cardioid::test {
namespace {

struct Trial {
    std::string module;
    Setting setting;
};

std::string name_of(const testing::TestParamInfo<Trial>& info) {
    const KnownValue& first = info.param.setting.front();
    return info.param.module + "_" + plain_name(first.title()) + "_" + std::to_string(info.index);
}

std::vector<Trial> trials() {
    std::vector<Trial> all;
    for (const std::string module : {"path", "photon"})
        for (const Setting& setting : known_settings(module, Run::whole)) all.push_back({module, setting});
    return all;
}

class EveryKnownValue : public testing::TestWithParam<Trial> {};

TEST_P(EveryKnownValue, IsWithinItsTolerance) {
    const Setting& setting = GetParam().setting;
    const std::vector<Verdict> verdicts = judge(setting, GetParam().module);
    for (std::size_t i = 0; i < setting.size(); ++i) {
        SCOPED_TRACE(setting[i].title());
        const Verdict& verdict = verdicts[i];
        EXPECT_TRUE(verdict.sure) << "standard error " << verdict.standard_error;
        EXPECT_TRUE(verdict.right) << "found " << verdict.found.value << ", wanted " << setting[i].expected
                                   << ", error " << verdict.error << " +- " << verdict.standard_error;
        EXPECT_EQ(verdict.found.bad_samples, 0U);
    }
}

INSTANTIATE_TEST_SUITE_P(Table, EveryKnownValue, testing::ValuesIn(trials()), name_of);

/// The picture of a scene by path tracing, with a box filter.
std::vector<float> picture(const Scene& description, int width, int height, int samples) {
    const CommittedScene scene = commit(description);
    const auto lighting = prepared_lighting("path", scene, 1);
    RenderSettings settings{.width = width, .height = height, .samples = samples, .seed = 1};
    settings.camera = description.cameras.at(0);
    Progress silent;
    return render(scene, *lighting, settings, silent).film.layers.at(0).pixels;
}

double mean(const std::vector<float>& values) {
    double sum = 0;
    for (const float value : values) sum += static_cast<double>(value);
    return sum / static_cast<double>(values.size());
}

TEST(FurnacePicture, IsEvenInEveryPixel) {
    for (const char* file : {"accuracy/rooms/furnace.csg", "accuracy/rooms/nested_furnace.csg"}) {
        const std::vector<float> pixels = picture(sample_scene(file), 12, 9, 1 << 15);
        EXPECT_NEAR(mean(pixels), 2, 0.002 * 2) << file;
        for (const float pixel : pixels) EXPECT_NEAR(static_cast<double>(pixel), 2, 0.01 * 2) << file;
    }
}

constexpr int size = 512, block = 8, blocks = size / block;

/// Means of 8 x 8 pixels.
std::vector<float> block_means(const std::vector<float>& pixels) {
    std::vector<float> means(std::size_t{3} * blocks * blocks);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const std::size_t pixel = i / 3, x = pixel % size / block, y = pixel / size / block;
        means[(y * blocks + x) * 3 + i % 3] += pixels[i] / (block * block);
    }
    return means;
}

/// Root of the mean of (a - r)^2 / (r^2 + 0.01), which dark places do not rule.
double relative_error(const std::vector<float>& a, const std::vector<float>& reference) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double r = static_cast<double>(reference[i]), off = static_cast<double>(a[i]) - r;
        sum += off * off / (r * r + 0.01);
    }
    return std::sqrt(sum / static_cast<double>(a.size()));
}

class CornellBox : public testing::TestWithParam<const char*> {};

TEST_P(CornellBox, ComesToItsReferenceWithTheRootOfTheSamples) {
    const std::string file = std::string("cornell/") + GetParam();
    const Scene scene = sample_scene(file + ".csg");
    const std::vector<float> reference =
        read_image(CARDIOID_SOURCE_DIR "/samples/" + file + "_blocks.exr").layers.at(0).pixels;
    const std::vector<float> few = block_means(picture(scene, size, size, 4));
    const std::vector<float> many = block_means(picture(scene, size, size, 64));
    ASSERT_EQ(many.size(), reference.size());
    EXPECT_NEAR(mean(many), mean(reference), 0.002 * mean(reference));
    const double first = relative_error(few, reference), last = relative_error(many, reference);
    RecordProperty("relative_error_4", std::to_string(first));
    RecordProperty("relative_error_64", std::to_string(last));
    // Sixteen times the samples: a quarter of the error.
    EXPECT_NEAR(std::log2(first / last), 2, 0.5) << first << " " << last;
}

std::string box_name(const testing::TestParamInfo<const char*>& info) { return info.param; }

INSTANTIATE_TEST_SUITE_P(Both, CornellBox, testing::Values("block", "spheres"), box_name);

}  // namespace
}  // namespace cardioid::test
