#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"

namespace cardioid::test {
namespace {

using Json = nlohmann::json;

constexpr const char* scene =
    "film([40, 30], samples = 4);\n"
    "camera([30, 40, 20], look_at = [0, 0, 0], name = \"far\");\n"
    "camera([12, 16, 8], look_at = [0, 0, 0], name = \"near\");\n"
    "define_material(\"glass\", kind = \"dielectric\");\n"
    "difference() { cube(8, center = true); sphere(5, $fn = 0); }\n"
    "material(\"glass\") sphere(3, $fn = 0);\n"
    "sky(\"studio\"); area_light([4, 4], radiance = 3);\n";

/// The picture file that these words give.
std::string picture(const std::vector<std::string>& more, const std::string& text = scene) {
    const Folder folder;
    folder.write("a.csg", text);
    std::vector<std::string> words{"a.csg", "-q"};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome run = folder.cardioid(words);
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.err, "");
    EXPECT_EQ(run.out, "");
    return folder.has("a.png") ? folder.read("a.png") : "";
}

TEST(Render, GivesTheSameFileForAnyNumberOfThreads) {
    const std::string one = picture({"-j", "1"});
    ASSERT_FALSE(one.empty());
    EXPECT_TRUE(one == picture({"-j", "2"}));
    EXPECT_TRUE(one == picture({"-j7"}));
    EXPECT_TRUE(one == picture({"--threads=2"}));
    EXPECT_FALSE(one == picture({"--seed", "1"}));
}

TEST(Render, NeedsNoCommandNoOutputAndNoLight) {
    const Folder folder;
    folder.write("part.csg", "cube(10);");
    const Outcome run = folder.cardioid({"part.csg", "-s", "32x24", "--spp", "2"});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_NE(run.err.find("part.png: 32x24, 2 samples a pixel"), std::string::npos) << run.err;
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"part.csg", "part.png"}));
}

TEST(Render, SaysThatAPictureIsBlack) {
    const Folder folder;
    const std::string lamp = "translate([0, 0, 9]) area_light([4, 4]); cube(2); ";
    folder.write("lit.csg", lamp + "camera([9, 9, 20], look_at = [0, 0, 0]);");
    folder.write("away.csg", lamp + "camera([9, 9, 20], look_at = [0, 0, 90]);");
    EXPECT_EQ(folder.cardioid({"lit.csg", "-s", "8x8"}).err.find("black"), std::string::npos);
    EXPECT_NE(folder.cardioid({"away.csg", "-s", "8x8"}).err.find("the picture is black"), std::string::npos);
}

TEST(Render, ReadsStandardInput) {
    const Folder folder;
    EXPECT_EQ(folder.cardioid({"-", "-s", "8", "--spp", "1"}, {.input = "cube(1);"}).status, 0);
    EXPECT_TRUE(folder.has("stdin.png"));
    const Outcome bad = folder.cardioid({"render", "-", "-o", "b.png"}, {.input = "cube(1);\ncub(2);"});
    EXPECT_EQ(bad.status, 3);
    EXPECT_NE(bad.err.find("<stdin>:2:1: "), std::string::npos) << bad.err;
    EXPECT_FALSE(folder.has("b.png"));
}

/// Pairs of command lines that must give the same picture, and the first must not give the picture without options.
struct Same {
    std::vector<std::string> one, other;
};
/// Pixels alone: metadata names the command line.
std::string pixels(const std::vector<std::string>& more) {
    const Folder folder;
    folder.write("a.csg", scene);
    folder.write("paint.csg", "define_material(\"glass\", kind = \"diffuse\");");
    std::vector<std::string> words{"a.csg", "-q", "-o", "a.ppm"};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome run = folder.call(words);
    EXPECT_EQ(run.status, 0) << run.err;
    return folder.has("a.ppm") ? folder.read("a.ppm") : "";
}

TEST(RenderOption, HasAnEffectAndTwoSpellings) {
    const std::string plain = pixels({});
    for (const Same& same : std::vector<Same>{
             Same{{"-s", "20"}, {"--size=20x20"}}, Same{{"--spp", "9"}, {"--spp=9"}},
             Same{{"--quality", "normal"}, {"--spp", "32"}}, Same{{"--quality", "high", "--spp", "2"}, {"--spp", "2"}},
             Same{{"--seed", "3"}, {"--seed=3"}}, Same{{"-e", "-20"}, {"--elevation=-20", "-a", "35"}},
             Same{{"-a", "-30"}, {"-a330", "-e", "25"}},
             Same{{"--eye", "-9,12,-13"}, {"--eye=-9,12,-13", "--target", "0,0,0"}},
             Same{{"--eye", "0,0,30"}, {"--eye", "[0, 0, 30]"}}, Same{{"--camera", "near"}, {"--camera=near"}},
             Same{{"--fov", "20"}, {"--camera", "far", "--fov", "20"}},
             Same{{"--exposure", "-1.5"}, {"--exposure=-1.5"}}, Same{{"--view", "normal"}, {"--view=normal"}},
             Same{{"--crop", "4,5,20,25"}, {"--crop", "4, 5, 20, 25"}},
             Same{{"--facets", "openscad"}, {"--smooth-from", "30", "--facets=openscad"}},
             Same{{"--ground"}, {"--ground", "--no-photons"}}}) {
        const std::string one = pixels(same.one);
        EXPECT_TRUE(one == pixels(same.other)) << same.one[0];
        EXPECT_FALSE(one == plain) << same.one[0];
    }
}

TEST(Render, CropGivesThePixelsOfTheWholePicture) {
    const std::string whole = pixels({}), part = pixels({"--crop", "4,5,20,25"});
    const std::string head = "P6\n40 30\n255\n", part_head = "P6\n16 20\n255\n";
    const auto body = [](const std::string& file, std::size_t bytes) { return file.substr(file.size() - bytes); };
    const std::string all = body(whole, 40 * 30 * 3), some = body(part, 16 * 20 * 3);
    for (std::size_t row = 0; row < 20; ++row)
        EXPECT_EQ(some.substr(row * 16 * 3, 16 * 3), all.substr(((row + 5) * 40 + 4) * 3, 16 * 3)) << row;
}

TEST(Render, WritesLayersBesideAPngAndIntoAnExr) {
    const Folder folder;
    folder.write("a.csg", scene);
    EXPECT_EQ(folder.call({"a.csg", "-q", "--aov", "normal,depth,normal"}).status, 0);
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.csg", "a.depth.png", "a.normal.png", "a.png"}));
    EXPECT_EQ(folder.call({"a.csg", "-q", "--half", "--aov", "direct,specular", "-o", "a.exr"}).status, 0);
    const std::string info = folder.call({"info", "a.exr"}).out;
    EXPECT_NE(info.find("direct"), std::string::npos) << info;
    EXPECT_NE(info.find("specular"), std::string::npos) << info;
}

TEST(Render, StatisticsTellCountsMemoryAndTimes) {
    const Folder folder;
    folder.write("a.csg", scene);
    EXPECT_EQ(folder.call({"a.csg", "-q", "--stats", "a.json"}).status, 0);
    const Json json = Json::parse(folder.read("a.json"));
    EXPECT_EQ(json["picture"]["width"], 40);
    EXPECT_EQ(json["picture"]["samples"], 4);
    EXPECT_EQ(json["rays"]["camera"], 40 * 30 * 4);
    EXPECT_EQ(json["scene"]["leaves"], 3);
    EXPECT_GT(json["memory_bytes"]["bytes_a_leaf"], 0);
    EXPECT_EQ(json["bad_samples"]["count"], 0);
    EXPECT_EQ(json["interrupted"], false);
    for (const char* const phase : {"read", "build", "prepare", "render", "write", "render_cpu"})
        EXPECT_GE(json["seconds"][phase], 0) << phase;
    EXPECT_TRUE(json["versions"].contains("embree"));
}

TEST(Render, TimeAndNoiseEndIt) {
    const Folder folder;
    folder.write("a.csg", scene);
    EXPECT_EQ(folder.call({"a.csg", "-q", "--time", "0.3s", "--stats", "a.json"}).status, 0);
    EXPECT_GT(Json::parse(folder.read("a.json"))["picture"]["samples"], 4);
    EXPECT_EQ(folder.call({"a.csg", "-q", "-s", "8", "--noise", "20%", "--stats", "a.json"}).status, 0);
    EXPECT_GT(Json::parse(folder.read("a.json"))["picture"]["samples"], 4);
}

TEST(Render, WarningsGoToStandardErrorUnlessQuiet) {
    const Folder folder;
    folder.write("a.csg", "cube(1); sphere(0);");
    const std::vector<std::string> words{"a.csg", "-s", "4", "--spp", "1"};
    const Outcome run = folder.call(words);
    EXPECT_EQ(run.status, 0);
    EXPECT_NE(run.err.find("cardioid: warning: a.csg:1:10: "), std::string::npos) << run.err;
    std::vector<std::string> quiet = words;
    quiet.emplace_back("-q");
    EXPECT_EQ(folder.call(quiet).err, "");
    std::vector<std::string> verbose = words;
    verbose.emplace_back("-v");
    EXPECT_NE(folder.call(verbose).err.find("rays: 16 camera"), std::string::npos);
}

TEST(Render, UnknownCallsMayBeGroups) {
    const Folder folder;
    folder.write("a.csg", "frobnicate() cube(1);");
    EXPECT_EQ(folder.call({"a.csg"}).status, 3);
    const Outcome run = folder.call({"a.csg", "--unknown=warn", "-s", "4", "--spp", "1"});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_NE(run.err.find("frobnicate"), std::string::npos);
}

TEST(Render, MaterialsComeFromASideFile) {
    const Folder folder;
    folder.write("a.csg", "color([1, 0, 0, 1]) cube(1);");
    folder.write("paint.csg",
                 "define_material(\"paint\", kind = \"emitter\", emission = [0, 0, 5]);\n"
                 "map_color([1, 0, 0, 1], \"paint\");");
    const std::vector<std::string> words{"info", "a.csg", "--json", "-"};
    std::vector<std::string> painted = words;
    painted.insert(painted.end(), {"--materials", "paint.csg"});
    EXPECT_EQ(folder.call(words).out.find("paint"), std::string::npos);
    EXPECT_NE(folder.call(painted).out.find("paint"), std::string::npos);
    folder.write("paint.csg", "\n map_colour([1, 0, 0, 1], \"paint\");");
    const Outcome bad = folder.call({"a.csg", "--materials", "paint.csg"});
    EXPECT_EQ(bad.status, 3);
    EXPECT_NE(bad.err.find("paint.csg:2:2: "), std::string::npos) << bad.err;
    EXPECT_EQ(folder.call({"a.csg", "--materials", "none.csg"}).status, 4);
}

TEST(Render, FilesOfAPlaceAreFoundByTheBaseFolder) {
    const Folder folder;
    std::filesystem::create_directory(folder.path("parts"));
    folder.write("parts/t.stl",
                 "solid t\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
                 "endloop\nendfacet\nendsolid t\n");
    folder.write("a.csg", "import(file = \"t.stl\");");
    const std::vector<std::string> words{"info", "a.csg", "--json", "-"};
    std::vector<std::string> based = words;
    based.insert(based.end(), {"--base-dir", "parts"});
    const Outcome run = folder.call(based);
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_NE(run.out.find("\"triangles\": 1"), std::string::npos) << run.out;
}

}  // namespace
}  // namespace cardioid::test
