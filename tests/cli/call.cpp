#include <gtest/gtest.h>

#include "cli/run.hpp"
#include "tests/cli/program.hpp"

namespace cardioid::test {

Outcome Folder::call(const std::vector<std::string>& arguments) const {
    const std::filesystem::path here = std::filesystem::current_path();
    std::filesystem::current_path(root_);
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    Outcome outcome;
    outcome.status = cli::run(arguments);
    outcome.out = testing::internal::GetCapturedStdout();
    outcome.err = testing::internal::GetCapturedStderr();
    std::filesystem::current_path(here);
    return outcome;
}

}  // namespace cardioid::test
