#include "tests/accuracy/results.hpp"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>

#include "rt_core/api/error.hpp"

namespace cardioid::test {
namespace {

/// A file that is gone after the test.
class ResultsFile : public testing::Test {
protected:
    void TearDown() override { std::filesystem::remove(file_); }
    std::string file_ =
        (std::filesystem::temp_directory_path() / ("cardioid_results_" + std::to_string(getpid()) + ".json")).string();
    KnownValue known_ = known_values().front();
    Verdict sure_ = verdict_of(known_, "path", {.value = known_.expected, .runs = 8, .samples = 9, .cpu_s = 2});
};

TEST_F(ResultsFile, KeepsWhatWasMeasuredForTheNextTime) {
    Results(file_).add(known_, "path", sure_);
    const Results again(file_);
    ASSERT_TRUE(again.find(known_, "path"));
    EXPECT_EQ(again.find(known_, "path")->found.value, sure_.found.value);
    EXPECT_EQ(again.find(known_, "path")->found.samples, 9U);
    EXPECT_TRUE(again.find(known_, "path")->good());
    EXPECT_FALSE(again.find(known_, "photon"));
}

TEST_F(ResultsFile, ForgetsWhatWasMeasuredOfSomethingElse) {
    Results(file_).add(known_, "path", sure_);
    const Results again(file_);
    KnownValue other = known_;
    other.place.u.x *= 1.001;
    EXPECT_FALSE(again.any(other, "path"));
    other = known_;
    other.change.front().second += " ";
    EXPECT_FALSE(again.any(other, "path"));
    other = known_;
    other.tolerances[""] /= 2;
    EXPECT_FALSE(again.any(other, "path"));
}

TEST_F(ResultsFile, DoesNotTakeAnUnsureResultForTheLastWord) {
    Verdict unsure = sure_;
    unsure.found.standard_error = known_.expected;
    Results(file_).add(known_, "path", unsure);
    EXPECT_FALSE(Results(file_).find(known_, "path"));
    EXPECT_TRUE(Results(file_).any(known_, "path"));
    unsure.found.samples = 1U << 23;  // all that may be drawn
    Results(file_).add(known_, "path", unsure);
    EXPECT_TRUE(Results(file_).find(known_, "path"));
}

TEST_F(ResultsFile, ThatIsNoneIsAnError) {
    std::ofstream(file_) << "{\"a\": ";
    EXPECT_THROW(Results{file_}, Error);
}

}  // namespace
}  // namespace cardioid::test
