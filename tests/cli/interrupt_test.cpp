#include <chrono>
#include <gtest/gtest.h>
#include <signal.h>
#include <thread>

#include "tests/cli/program.hpp"

namespace cardioid::test {
namespace {

/// Far more samples than any test waits for.
const std::vector<std::string> endless{"a.csg", "-s", "64", "--spp", "16000000", "-v"};

/// Until the process says that it draws.
void wait_for_first_pixels(const Folder& folder) {
    for (int i = 0; i < 600 && folder.messages().find("render\n") == std::string::npos; ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
}

class Interrupt : public testing::TestWithParam<int> {};

TEST_P(Interrupt, OnceSavesWhatThereIsAndEndsWith130) {
    const Folder folder;
    folder.write("a.csg", "sphere(1);");
    std::vector<std::string> words = endless;
    words.insert(words.end(), {"--stats", "a.json"});
    const pid_t process = folder.begin(words);
    wait_for_first_pixels(folder);
    kill(process, GetParam());
    const Outcome run = folder.finish(process);
    EXPECT_EQ(run.status, 130) << run.err;
    EXPECT_NE(run.err.find("cardioid: interrupted; a.png has what was drawn so far"), std::string::npos) << run.err;
    EXPECT_NE(folder.read("a.json").find("\"interrupted\": true"), std::string::npos);
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.csg", "a.json", "a.png"}));
    EXPECT_NE(folder.cardioid({"info", "a.png"}).out.find("size: 64x64"), std::string::npos);
}

/// Balls whose union takes far longer than the test waits.
std::string many_balls() {
    std::string out;
    for (int i = 0; i < 64; ++i)
        out += "translate([" + std::to_string(i % 8) + ", " + std::to_string(i / 8) + ", 0]) sphere(0.9);\n";
    return out;
}

TEST_P(Interrupt, EndsAConversionBetweenBooleansAndWritesNothing) {
    const Folder folder;
    folder.write("a.csg", many_balls());
    const pid_t process = folder.begin({"convert", "a.csg", "-o", "a.stl", "--tolerance", "1e-5"});
    std::this_thread::sleep_for(std::chrono::milliseconds(1500));
    kill(process, GetParam());
    const auto then = std::chrono::steady_clock::now();
    const Outcome run = folder.finish(process);
    EXPECT_LT(std::chrono::steady_clock::now() - then, std::chrono::seconds(10));  // on a machine that is busy
    EXPECT_EQ(run.status, 130) << run.err;
    EXPECT_NE(run.err.find("interrupted while solids were evaluated"), std::string::npos) << run.err;
    EXPECT_EQ(folder.names(), std::vector<std::string>{"a.csg"});
}

INSTANTIATE_TEST_SUITE_P(Signals, Interrupt, testing::Values(SIGINT, SIGTERM));

}  // namespace
}  // namespace cardioid::test
