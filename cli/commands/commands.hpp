#pragma once
#include <string>
#include <vector>

namespace cardioid::cli {

// The commands. Each takes the words after its name and returns the exit status, or throws Error.

int run_render(const std::vector<std::string>& words);
int run_probe(const std::vector<std::string>& words);
int run_compare(const std::vector<std::string>& words);
int run_convert(const std::vector<std::string>& words);
int run_info(const std::vector<std::string>& words);
int run_check(const std::vector<std::string>& words);
int run_list(const std::vector<std::string>& words);

}  // namespace cardioid::cli
