#pragma once
#include <string>
#include <vector>

#include "tests/arch/source_tree.hpp"

namespace cardioid::test {

/// Who may include whom: what in `source` breaks a rule, a line each as "path:line: complaint"; empty where all is
/// well. The rules are those of the rooms: includes point downward only, and are written from the top of the tree.
std::vector<std::string> include_complaints(const Source& source);

/// What is wrong with the file itself: a header without a guard, or more than 400 lines outside of `*_table.cpp`.
std::vector<std::string> file_complaints(const Source& source);

}  // namespace cardioid::test
