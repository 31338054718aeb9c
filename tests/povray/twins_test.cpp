/// Each scene is drawn by both programs and compared; then with a mistake put into ours, which must be seen.
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>

#include "cli/compare/compare_options.hpp"
#include "formats/openscad/openscad_format.hpp"
#include "formats/povray/povray_format.hpp"
#include "rt_core/image/atomic_file.hpp"
#include "tests/povray/gallery.hpp"
#include "tests/povray/povray.hpp"
#include "tests/povray/twin.hpp"

namespace cardioid::test {
namespace {

namespace fs = std::filesystem;

class PovRay : public testing::TestWithParam<std::string> {};

std::string sdl_of(const Scene& scene, const WriteOptions& writing = {}) {
    return formats::pov_format.write(scene, writing);
}

cli::CompareOptions options_of(const Twin& twin) {
    return *cli::parse_compare_options({"ours", "povray", "--limits", twin.limits().string()});
}

/// Pictures that are timed are larger than those that are compared, or both programs would mostly start; but POV-Ray's
/// radiosity takes long enough as it is.
std::pair<int, int> timed_size(const Twin& twin, const Scene& scene) {
    if (twin.writing().photons) return {*scene.film.width, *scene.film.height};
    return {480, 360};
}

/// Processor time of the rendering alone. Of a run of its own, because --stats works out more than the picture.
double rendering_seconds(std::vector<std::string> words, const fs::path& folder) {
    words.insert(words.end(), {"--stats", "timed.json"});
    EXPECT_EQ(run(words, folder).status, 0);
    std::ifstream stats(folder / "timed.json");
    return nlohmann::json::parse(stats).at("seconds").at("render_cpu");
}

/// What the programs take for the scene, start, reading and writing included.
void time_programs(const Twin& twin, const Scene& scene, Entry& entry) {
    const fs::path folder = fs::path(report_folder()) / twin.name();
    fs::create_directories(folder);
    const std::string text = formats::csg_format.write(scene, {});
    write_whole_file((folder / "scene.csg").string(), std::as_bytes(std::span(text)));
    const Drawing drawing = twin.drawing();
    const auto [width, height] = timed_size(twin, scene);
    entry.size = fmt::format("{}x{}", width, height);
    const std::string samples = std::to_string(drawing.samples);
    const std::vector<std::string> words{
        CARDIOID_PROGRAM, "scene.csg", "-o",    "timed.exr",  "--half",        "-q", "-j", "1", "-s",
        entry.size,       "--spp",     samples, "--lighting", drawing.lighting};
    const Run done = run(words, folder);
    ASSERT_EQ(done.status, 0) << done.messages;
    entry.our_s = done.user_s;
    entry.direct = !twin.writing().photons;
    // Photons are part of the drawing, but not of what is counted there.
    entry.our_render_s = entry.direct ? rendering_seconds(words, folder) : entry.our_s;
    entry.povray_s = draw_by_povray(sdl_of(scene, twin.writing()), width, height).user_s;
}

int differing_outline(const Scene& scene) {
    const Scene outline = outline_of(scene);
    const Picture ours = draw(outline, {});
    const Picture theirs = draw_by_povray(sdl_of(outline), ours.width, ours.height).picture;
    int count = 0;
    for (std::size_t i = 0; i < ours.pixels.size(); ++i)
        count += (ours.pixels[i].r > 0.5F) != (theirs.pixels[i].r > 0.5F);
    return count;
}

/// What scenes without noise are held to: a relative difference of 1e-3 on 99.9 % of the pixels off outlines, outlines
/// equal to the pixel, 5 pixels for rings; and each must see a light 2 % brighter.
TEST_P(PovRay, IsHeldToWhatWasPromised) {
    const Twin twin(GetParam());
    const cli::CompareOptions options = options_of(twin);
    if (options.limits.contains("beyond")) {
        EXPECT_EQ(options.settings.tolerance, 1e-3);
        EXPECT_LE(options.limits.at("beyond"), 1e-3);
    } else {
        EXPECT_TRUE(options.limits.contains("bias"));
        EXPECT_FALSE(options.settings.regions.empty() && options.grid == 0);
    }
    if (twin.writing().photons) {
        EXPECT_LE(options.limits.at("bias"), 0.02);
    }
    EXPECT_LE(twin.silhouette(), twin.name() == "torus" ? 5 : 0);
    if (twin.name() != "area_array_shadow") {
        EXPECT_EQ(twin.wrong().at(0), "light");
    }
}

TEST_P(PovRay, DrawsTheSamePictureAndNotThatOfAMistake) {
    if (!has_povray()) GTEST_SKIP() << "povray is not installed";
    const Twin twin(GetParam());
    if (!twin.can_run()) GTEST_SKIP() << "openscad's examples are not installed";
    const Scene scene = twin.read();
    const cli::CompareOptions options = options_of(twin);
    PovPicture theirs = draw_by_povray(sdl_of(scene, twin.writing()), *scene.film.width, *scene.film.height);
    theirs.picture.path = "POV-Ray";
    const Picture ours = draw(scene, twin.drawing());
    const Comparison comparison = compare(ours, theirs.picture, options.settings);
    const cli::Verdict verdict = cli::judge(comparison, options);

    Entry entry{twin.name(), twin.proves()};
    entry.good = verdict.good;
    entry.verdict = verdict.text;
    entry.beyond = comparison.whole.beyond, entry.bias = comparison.whole.bias, entry.flip = comparison.whole.flip;
    time_programs(twin, scene, entry);
    EXPECT_TRUE(verdict.good) << cli::comparison_text(comparison, verdict);
    if (twin.silhouette() >= 0) {
        entry.silhouette = differing_outline(scene);
        EXPECT_LE(entry.silhouette, twin.silhouette());
    }
    for (const std::string& mistake : twin.wrong()) {
        const Comparison wrong =
            compare(draw(with_mistake(scene, mistake), twin.drawing()), theirs.picture, options.settings);
        if (!cli::judge(wrong, options).good) entry.caught.push_back(mistake);
    }
    EXPECT_EQ(entry.caught, twin.wrong()) << "a mistake went unseen";

    add_to_gallery(entry, ours, theirs.picture);
    const std::string page = cli::report_page(ours, theirs.picture, comparison, verdict, options);
    write_whole_file((fs::path(report_folder()) / twin.name() / "index.html").string(), std::as_bytes(std::span(page)));
}

INSTANTIATE_TEST_SUITE_P(Scene, PovRay, testing::ValuesIn(twin_names()),
                         [](const auto& instance) { return instance.param; });

}  // namespace
}  // namespace cardioid::test
