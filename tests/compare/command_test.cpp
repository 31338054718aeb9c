#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "rt_core/image/image_file.hpp"
#include "tests/cli/program.hpp"

namespace cardioid::test {
namespace {

using ::testing::HasSubstr;

/// A soft pattern of the given brightness.
Film film(float brightness, int width = 24) {
    Film out{width, 16, {{"", 3, {}}}};
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < 3; ++c)
                out.layers[0].pixels.push_back(brightness * (0.2F + 0.03F * static_cast<float>(x + y + c)) / 1.4F);
    return out;
}

class Compare : public testing::Test {
protected:
    Compare() {
        write_image(folder.path("a.exr").string(), film(1), {});
        write_image(folder.path("same.exr").string(), film(1), {});
        write_image(folder.path("b.exr").string(), film(1.01F), {});
    }
    [[nodiscard]] Outcome run(std::vector<std::string> words) const {
        words.insert(words.begin(), "compare");
        return folder.call(words);
    }
    Folder folder;
};

TEST_F(Compare, SaysZeroForTheSameAndOneForOthersWhereNoLimitIsGiven) {
    EXPECT_EQ(run({"a.exr", "same.exr"}).status, 0);
    const Outcome other = run({"a.exr", "b.exr"});
    EXPECT_EQ(other.status, 1);
    EXPECT_THAT(other.out, HasSubstr("no limit says"));
}

TEST_F(Compare, HoldsEachLimit) {
    for (const char* limit : {"--max-rmse=0.02", "--max-relmse=0.001", "--max-bias=1.1%", "--max-flip=0.05",
                              "--max-p999=0.05", "--max-difference=0.05"})
        EXPECT_EQ(run({"a.exr", "b.exr", limit}).status, 0) << limit;
    for (const char* limit : {"--max-rmse=0.001", "--max-relmse=0.00001", "--max-bias=0.9%", "--max-flip=0.0001",
                              "--max-p999=0.001", "--max-difference=0.001", "--max-beyond=50%", "--max-z=3"})
        EXPECT_EQ(run({"a.exr", "b.exr", limit}).status, 1) << limit;
}

TEST_F(Compare, ReadsLimitsFromAFileAndTheCommandLineWins) {
    folder.write("limits.json", R"({"proves": "it", "limits": {"rmse": 0.001}, "grid": 2})");
    EXPECT_EQ(run({"a.exr", "b.exr", "--limits", "limits.json"}).status, 1);
    EXPECT_EQ(run({"a.exr", "b.exr", "--limits", "limits.json", "--max-rmse", "1"}).status, 0);
    EXPECT_THAT(run({"a.exr", "b.exr", "--limits", "limits.json"}).out, HasSubstr("row 2, column 2"));
}

TEST_F(Compare, RefusesAFileOfLimitsItDoesNotUnderstand) {
    folder.write("limits.json", R"({"limits": {"rsme": 0.001}})");
    const Outcome wrong = run({"a.exr", "b.exr", "--limits", "limits.json"});
    EXPECT_EQ(wrong.status, 3);
    EXPECT_THAT(wrong.err, HasSubstr("did you mean \"rmse\""));
    folder.write("limits.json", "{");
    EXPECT_EQ(run({"a.exr", "b.exr", "--limits", "limits.json"}).status, 3);
    EXPECT_EQ(run({"a.exr", "b.exr", "--limits", "missing.json"}).status, 4);
}

TEST_F(Compare, TellsSizesThatDiffer) {
    write_image(folder.path("wide.exr").string(), film(1, 30), {});
    const Outcome wrong = run({"a.exr", "wide.exr", "--max-rmse", "100"});
    EXPECT_EQ(wrong.status, 1);
    EXPECT_THAT(wrong.err, HasSubstr("30x16"));
}

TEST_F(Compare, TakesWhatADisplayGetsForTheLightItMeans) {
    write_image(folder.path("a.png").string(), film(1), {});
    EXPECT_EQ(run({"a.png", "a.exr", "--max-difference", "0.006"}).status, 0);
    EXPECT_EQ(run({"a.png", "a.exr", "--max-difference", "0.0001"}).status, 1);
}

TEST_F(Compare, SaysTwoForWrongUseAndFourForMissingFiles) {
    EXPECT_EQ(run({"a.exr"}).status, 2);
    EXPECT_EQ(run({"a.exr", "b.exr", "--max-rmse", "much"}).status, 2);
    EXPECT_EQ(run({"a.exr", "b.exr", "--skip-edges"}).status, 2);
    EXPECT_EQ(run({"a.exr", "b.exr", "--region", "here"}).status, 2);
    EXPECT_EQ(run({"a.exr", "missing.exr"}).status, 4);
}

TEST_F(Compare, WritesAllFiguresAsJson) {
    EXPECT_EQ(run({"a.exr", "b.exr", "--max-bias", "1.1%", "--json", "out.json", "--region", "corner=0,0,4,4"}).status,
              0);
    const auto json = nlohmann::json::parse(folder.read("out.json"));
    EXPECT_TRUE(json["equal"]);
    EXPECT_NEAR(json["whole"]["bias"].get<double>(), -0.0099, 1e-4);
    EXPECT_EQ(json["regions"][0]["name"], "corner");
    EXPECT_EQ(json["checks"].size(), 2U);
}

TEST_F(Compare, LooksAtEachRegionItIsGiven) {
    EXPECT_EQ(run({"a.exr", "b.exr", "--json", "out.json", "--region", "one=0,0,4,4", "--region=two=4,0,8,4"}).status,
              1);
    const auto json = nlohmann::json::parse(folder.read("out.json"));
    ASSERT_EQ(json["regions"].size(), 2U);
    EXPECT_EQ(json["regions"][1]["name"], "two");
    EXPECT_EQ(run({"a.exr", "b.exr", "--region"}).status, 2);
}

TEST_F(Compare, WritesAPageThatNeedsNothingElse) {
    EXPECT_EQ(run({"a.exr", "b.exr", "--report", "out/page"}).status, 1);
    const std::string page = folder.read("out/page/index.html");
    EXPECT_THAT(page, HasSubstr("\"figures\":[{\"name\":\"all\""));
    EXPECT_EQ(page.find("http://"), std::string::npos);
    EXPECT_EQ(page.find("https://"), std::string::npos);
    EXPECT_EQ(page.find("src="), std::string::npos);
    EXPECT_EQ(page.find("/*DATA*/"), std::string::npos);
}

TEST_F(Compare, ReadsLimitsFromATomlFile) {
    folder.write("test.toml",
                 "# of a pattern\ngrid = 2\n\n[limits]\nbias = 0.02  # a fiftieth\n"
                 "[regions]\n'left half' = [0, 0, 12, 16]\n");
    const Outcome good = run({"b.exr", "a.exr", "--limits", "test.toml"});
    EXPECT_EQ(good.status, 0) << good.out << good.err;
    EXPECT_THAT(good.out, HasSubstr("left half"));
    folder.write("test.toml", "[limits]\nbias = 0.005\n");
    EXPECT_EQ(run({"b.exr", "a.exr", "--limits", "test.toml"}).status, 1);
}

TEST_F(Compare, NamesTheLineOfATomlFileThatItCannotRead) {
    const std::pair<const char*, const char*> cases[] = {
        {"grid = 2\nbias", "test.toml:2: found \"bias\""},
        {"[limits]\nbias = {a = 1}", "test.toml:2: found \"{a = 1}\""},
        {"[limits]\nbias = 1\nbias = 2", "test.toml:3: found \"bias\", wanted each name once"},
        {"[limits]\nbaas = 1", "did you mean \"bias\""},
        {"grid = 0", "\"grid\" must be a whole number"},
        {"skip-edges = 1", "must be true or false"}};
    for (const auto& [text, message] : cases) {
        folder.write("test.toml", text);
        const Outcome bad = run({"a.exr", "b.exr", "--limits", "test.toml"});
        EXPECT_EQ(bad.status, 3) << text;
        EXPECT_THAT(bad.err, HasSubstr(message));
    }
}

}  // namespace
}  // namespace cardioid::test
