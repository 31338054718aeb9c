#include <algorithm>
#include <chrono>
#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <signal.h>
#include <sstream>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <thread>

#include "tests/cli/program.hpp"

namespace cardioid::test {
namespace {

/// A floor with a point lamp 2 above it, 8 W/sr: E = 8 * 2 / (4 + r^2)^1.5.
constexpr const char* scene =
    "translate([-5, -5, -1]) cube([10, 10, 1]);\n"
    "translate([0, 0, 2]) point_light(intensity = 8);\n";

/// The six numbers of each line.
std::vector<std::vector<double>> table(const std::string& text) {
    std::vector<std::vector<double>> rows;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        rows.emplace_back();
        for (double x = 0; words >> x;) rows.back().push_back(x);
        EXPECT_EQ(rows.back().size(), 6U) << line;
        EXPECT_TRUE(words.eof()) << line;
    }
    return rows;
}

/// A folder with the scene as a.csg and the points as p.txt.
class Site : public Folder {
public:
    explicit Site(const std::string& points) {
        write("a.csg", scene);
        write("p.txt", points);
    }
};

TEST(ProbeCommand, GivesALineForEachPoint) {
    const Site folder("\xEF\xBB\xBF# a comment\n0 0 0 0 0 1\r\n\n1,0,0,0,0,1 # two\n\t0 +2 0 0 0 1e3\n0 0 1 0 0 -1");
    const Outcome run = folder.call({"probe", "a.csg", "--points", "p.txt", "--lighting", "direct"});
    EXPECT_EQ(run.status, 0) << run.err;
    const auto rows = table(run.out);
    ASSERT_EQ(rows.size(), 4U);
    EXPECT_NEAR(rows[0][0], 2, 1e-5);
    EXPECT_NEAR(rows[1][1], 16 / std::pow(5, 1.5), 1e-5);
    EXPECT_NEAR(rows[2][2], 16 / std::pow(8, 1.5), 1e-5);
    EXPECT_EQ(rows[3][0], 0);
    for (const auto& row : rows)
        for (std::size_t i = 3; i < 6; ++i) EXPECT_EQ(row[i], 0);
    EXPECT_NE(run.err.find("p.txt: 4 points, 4 samples"), std::string::npos) << run.err;
}

TEST(ProbeCommand, TracesPathsUnlessToldOtherwise) {
    const Site folder("0 0 0 0 0 1\n");
    const Outcome direct =
        folder.call({"probe", "a.csg", "--points", "p.txt", "--lighting", "direct", "--json", "-", "-q"});
    const Outcome path = folder.call({"probe", "a.csg", "--points", "p.txt", "--json", "-", "-q"});
    EXPECT_EQ(nlohmann::json::parse(direct.out)["lighting"], "direct");
    EXPECT_EQ(nlohmann::json::parse(path.out)["lighting"], "path");
    EXPECT_EQ(path.err + direct.err, "");
}

TEST(ProbeCommand, WritesJsonWithStatistics) {
    const Site folder("0 0 0 0 0 1\n0 0 -0.5 0 0 1\n");
    const Outcome run = folder.call({"probe", "a.csg", "--points", "p.txt", "--json", "p.json", "-o", "p.out",
                                     "--lighting", "direct", "--noise", "0.5%", "--seed", "3"});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_NE(run.err.find("1 of 2 points is inside opaque solids"), std::string::npos) << run.err;
    EXPECT_EQ(table(folder.read("p.out")).size(), 2U);
    const auto json = nlohmann::json::parse(folder.read("p.json"));
    EXPECT_EQ(json["what"], "irradiance");
    EXPECT_EQ(json["seed"], 3);
    EXPECT_EQ(json["noise"], 0.005);
    ASSERT_EQ(json["points"].size(), 2U);
    EXPECT_NEAR(json["points"][0]["value"][0], 2.0, 1e-5);
    EXPECT_EQ(json["points"][0]["standard_error"].size(), 3U);
    EXPECT_EQ(json["points"][0]["samples"], 1);
    EXPECT_EQ(json["points"][1]["buried"], true);
    EXPECT_EQ(json["statistics"]["points"], 2);
    EXPECT_EQ(json["statistics"]["buried_points"], 1);
    EXPECT_EQ(json["statistics"]["interrupted"], false);
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.csg", "p.json", "p.out", "p.txt"}));
}

TEST(ProbeCommand, MeasuresRadianceToo) {
    const Site folder("0 0 1 0 0 -1\n");
    const Outcome run =
        folder.call({"probe", "a.csg", "--points", "p.txt", "--what", "radiance", "--lighting", "direct"});
    // The default material reflects 0.6 of what falls on it.
    EXPECT_NEAR(table(run.out)[0][0], 0.6 * 2 / 3.14159265, 1e-5) << run.err;
}

struct Wrong {
    std::vector<std::string> words;
    int status;
    std::string message;
};

TEST(ProbeCommand, NamesWhatIsWrong) {
    const Site folder("0 0 0 0 0 1\n");
    folder.write("words.txt", "0 0 0 0 0 1\n0 1 x1 0 0 1\n");
    folder.write("few.txt", "\n# c\n0 0 0 0 1\n");
    folder.write("many.txt", "0 0 0 0 0 1 7\n");
    folder.write("nan.txt", "0 0 0 0 0 nan\n");
    folder.write("zero.txt", "1 2 3   0 0 0\n");
    folder.write("binary.txt", std::string("\0\1\2", 3));
    folder.write("endless.txt", std::string(100'000, '1'));
    const auto names = folder.names();
    const auto with = [](std::vector<std::string> more) {
        more.insert(more.begin(), {"probe", "a.csg"});
        return more;
    };
    for (const Wrong& wrong : std::vector<Wrong>{
             {{"probe"}, 2, "no SCENE is given"},
             {with({}), 2, "--points is needed"},
             {with({"--point", "p.txt"}), 2, "(did you mean \"--points\"?)"},
             {with({"--points", "p.txt", "--what", "radience"}), 2, "(did you mean \"radiance\"?)"},
             {with({"--points", "p.txt", "--spp", "15"}), 2, "a whole number from 16"},
             {with({"--points", "p.txt", "--noise", "0"}), 2, "--noise: found \"0\""},
             {with({"--points", "p.txt", "--lighting", "pth"}), 2, "(did you mean \"path\"?)"},
             {with({"--points", "p.txt", "-q", "-v"}), 2, "cannot be given together"},
             {with({"--points", "p.txt", "-o", "x", "--json", "x"}), 2, "name the same file"},
             {with({"--points", "p.txt", "-o", "a.csg"}), 2, "the scene itself"},
             {with({"--points", "p.txt", "--json", "p.txt"}), 2, "p.txt has the points"},
             {{"probe", "-", "--points", "-"}, 2, "SCENE - and --points - cannot be given together"},
             {with({"--points", "words.txt"}), 3, "words.txt:2:5: found \"x1\", wanted a number"},
             {with({"--points", "few.txt"}), 3, "few.txt:3:10: found 5 numbers, wanted six: x y z nx ny nz"},
             {with({"--points", "many.txt"}), 3, "many.txt:1:13: found \"7\" after six numbers"},
             {with({"--points", "nan.txt"}), 3, "nan.txt:1:11: found \"nan\", wanted a number"},
             {with({"--points", "zero.txt"}), 3, "zero.txt:1:9: found 0 0 0, wanted a direction"},
             {with({"--points", "binary.txt"}), 3, "binary.txt:1:1: found \"???\""},
             {with({"--points", "endless.txt"}), 3, "endless.txt:1:"},
             {with({"--points", "no.txt"}), 4, "no.txt: cannot be read: No such file"},
             {with({"--points", "."}), 4, ".: cannot be read: Is a directory"},
             {with({"--points", "p.txt", "-o", "no/such.txt"}), 4, "no/such.txt"},
             {{"probe", "no.csg", "--points", "p.txt"}, 4, "no.csg"}}) {
        const Outcome run = folder.call(wrong.words);
        EXPECT_EQ(run.status, wrong.status) << run.err << wrong.message;
        EXPECT_NE(run.err.find(wrong.message), std::string::npos) << run.err << wrong.message;
        EXPECT_EQ(run.err.find('\n'), run.err.size() - 1) << run.err;
        EXPECT_EQ(run.out, "");
        EXPECT_EQ(folder.names(), names);
    }
}

TEST(ProbeCommand, SaysThatASceneHasNoLight) {
    const Site folder("0 0 0 0 0 1\n");
    folder.write("a.csg", "translate([-5, -5, -1]) cube([10, 10, 1]);");
    const Outcome run = folder.call({"probe", "a.csg", "--points", "p.txt"});
    EXPECT_EQ(run.status, 0);
    EXPECT_EQ(run.out, "0 0 0 0 0 0\n");
    EXPECT_NE(run.err.find("warning: a.csg: no light"), std::string::npos) << run.err;
    folder.write("none.txt", "# nothing\n");
    const Outcome none = folder.call({"probe", "a.csg", "--points", "none.txt", "--json", "none.json"});
    EXPECT_EQ(none.status, 0);
    EXPECT_EQ(none.out, "");
    EXPECT_NE(none.err.find("there is no point to measure"), std::string::npos) << none.err;
    EXPECT_TRUE(nlohmann::json::parse(folder.read("none.json"))["points"].empty());
}

TEST(ProbeCommand, GivesTheSameBytesForAnyThreadsAndAnyPipe) {
    std::string points;
    for (int i = 0; i < 300; ++i) points += std::to_string(0.01 * i) + " 0.3 0 0 0.2 1\n";
    const Site folder(points);
    folder.write("a.csg", std::string(scene) +
                              "translate([1, 1, 1]) area_light([1, 2]); translate([0, 0, 0.5]) cube([0.2, 9, 0.1]);");
    const auto run = [&](const std::vector<std::string>& more) {
        std::vector<std::string> words{"probe", "a.csg", "--noise", "5%", "-q"};
        words.insert(words.end(), more.begin(), more.end());
        return folder.cardioid(words, {.input = points}).out;
    };
    const std::string one = run({"--points", "p.txt", "-j", "1"});
    EXPECT_EQ(table(one).size(), 300U);
    EXPECT_EQ(run({"--points", "p.txt", "-j", "3"}), one);
    EXPECT_EQ(run({"--points", "-", "-j", "2"}), one);
    EXPECT_NE(run({"--points", "p.txt", "--seed", "1"}), one);
    // A pipe that brings half a line at a time.
    const Outcome slow = folder.shell(
        "(head -c 1234 p.txt; sleep 0.2; tail -c +1235 p.txt) | "
        "\"$CARDIOID\" probe a.csg --points - --noise 5% -q");
    EXPECT_EQ(slow.out, one);
}

TEST(ProbeCommand, AnswersAPipeBeforeItEnds) {
    const Site folder("");
    ASSERT_EQ(mkfifo(folder.path("in").c_str(), 0600), 0);
    ASSERT_EQ(mkfifo(folder.path("out").c_str(), 0600), 0);
    // One question at a time, as another program would ask; its answer must come while the pipe is still open.
    const Outcome run = folder.shell(
        "\"$CARDIOID\" probe a.csg --points in --lighting direct -q -o out & "
        "exec 4<out 3>in; echo 0 0 0 0 0 1 >&3; read a <&4; echo $a; "
        "echo 0 0 1 0 0 1 >&3; read b <&4; echo $b; exec 3>&-; wait");
    const auto rows = table(run.out);
    ASSERT_EQ(rows.size(), 2U) << run.err;
    EXPECT_NEAR(rows[0][0], 2, 1e-5);
    EXPECT_NEAR(rows[1][0], 8, 1e-4);
}

/// Peak memory [bytes] of a run over so many points along x; its lines are in p.out.
double peak_memory(const Folder& folder, int count) {
    std::string points;
    for (int i = 0; i < count; ++i) points += std::to_string(i * 4.0 / count) + " 0 0 0 0 1\n";
    folder.write("p.txt", points);
    const pid_t process = folder.begin({"probe", "a.csg", "--points", "p.txt", "--lighting", "direct", "-q", "-j", "1",
                                        "-o", "p.out", "--json", "p.json"});
    int status = -1;
    rusage usage{};
    wait4(process, &status, 0, &usage);
    EXPECT_EQ(status, 0) << folder.messages();
    return static_cast<double>(usage.ru_maxrss) * 1024;
}

TEST(ProbeCommand, MeasuresManyPointsInLittleTimeAndMemory) {
    const Site folder("");
    const double few = peak_memory(folder, 1000);
    const auto begin = std::chrono::steady_clock::now();
    constexpr int count = 200'000;
    const double many = peak_memory(folder, count);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(30));
#ifndef __SANITIZE_ADDRESS__  // which keeps what is freed
    // The points alone, all at once, would take as much.
    EXPECT_LT(many - few, count * 48.0);
#endif
    const std::string out = folder.read("p.out");
    EXPECT_EQ(std::count(out.begin(), out.end(), '\n'), count);
    const auto last = table(out.substr(out.rfind('\n', out.size() - 2) + 1))[0];
    EXPECT_NEAR(last[0], 16 / std::pow(20, 1.5), 1e-4);
    EXPECT_NE(folder.read("p.json").find("\"points\":200000"), std::string::npos);
}

TEST(ProbeCommand, InterruptedHasWholeLinesOfWhatItMeasured) {
    std::string points;
    for (int i = 0; i < 2000; ++i) points += std::to_string(0.001 * i) + " 0.3 0 0 0.2 1\n";
    const Site folder(points);
    folder.write("a.csg", std::string(scene) +
                              "translate([1, 1, 1]) area_light([1, 2]); translate([0, 0, 0.5]) cube([0.2, 9, 0.1]);");
    const pid_t process = folder.begin(
        {"probe", "a.csg", "--points", "p.txt", "--noise", "0.01%", "-v", "-o", "p.out", "--json", "p.json"});
    for (int i = 0; i < 600 && folder.messages().find("probe\n") == std::string::npos; ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    std::this_thread::sleep_for(std::chrono::milliseconds(1000));
    kill(process, SIGINT);
    const Outcome run = folder.finish(process);
    EXPECT_EQ(run.status, 130) << run.err;
    EXPECT_NE(run.err.find("cardioid: interrupted; the first "), std::string::npos) << run.err;
    const auto json = nlohmann::json::parse(folder.read("p.json"));
    EXPECT_EQ(json["statistics"]["interrupted"], true);
    EXPECT_EQ(table(folder.read("p.out")).size(), json["points"].size());
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.csg", "p.json", "p.out", "p.txt"}));
}

TEST(ProbeCommand, AFullDiskLeavesTheOldFile) {
    const Site folder("0 0 0 0 0 1\n");
    const Outcome run = folder.cardioid({"probe", "a.csg", "--points", "p.txt", "-q"}, {.out_file = "/dev/full"});
    EXPECT_EQ(run.status, 4);
    EXPECT_NE(run.err.find("standard output: cannot write"), std::string::npos) << run.err;
    std::string many;
    for (int i = 0; i < 2000; ++i) many += "0 0 0 0 0 1\n";
    folder.write("p.txt", many);
    folder.write("p.out", "old");
    const Outcome full =
        folder.shell("ulimit -f 1; exec \"$CARDIOID\" probe a.csg --points p.txt --lighting direct -q -o p.out");
    EXPECT_EQ(full.status, 4) << full.err;
    EXPECT_EQ(folder.read("p.out"), "old");
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.csg", "p.out", "p.txt"}));
}

TEST(RenderCommand, TellsWhereTheLightGoes) {
    const Site folder("");
    folder.write("a.csg",
                 "difference() { cube(4, center = true); sphere(1); }\n"
                 "point_light(power = 12);\n camera([0.5, 0, 0], look_at = [0, 0, 0]);");
    const Outcome run =
        folder.cardioid({"a.csg", "-s", "4", "--spp", "1", "-v", "--stats", "s.json", "--lighting", "path"});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_NE(run.err.find("energy: 36 W of light = "), std::string::npos) << run.err;
    EXPECT_NE(run.err.find("absorbed by default: "), std::string::npos) << run.err;
    const auto energy = nlohmann::json::parse(folder.read("s.json"))["energy_W"];
    EXPECT_LT(energy["imbalance"], 1e-5);
    EXPECT_EQ(energy["escaped"]["sum"], 0);
    EXPECT_NEAR(energy["emitted"]["rgb"][1], 12, 1e-4);
    EXPECT_NEAR(energy["power_of_lights"]["sum"], 36, 1e-4);
    EXPECT_NEAR(double{energy["absorbed"]["sum"]} + double{energy["cut_off"]["sum"]}, 36, 1e-3);
    EXPECT_EQ(energy["absorbed_by"][0]["material"], "default");
}

}  // namespace
}  // namespace cardioid::test
