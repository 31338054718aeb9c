#pragma once
#include <string>
#include <vector>

namespace cardioid::cli {

/// The program: does what the words after its name say. What goes wrong is one line on standard error; returns the
/// exit status. Throws nothing.
int run(const std::vector<std::string>& words) noexcept;

}  // namespace cardioid::cli
