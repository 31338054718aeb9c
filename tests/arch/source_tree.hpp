#pragma once
#include <cstddef>
#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace cardioid::test {

/// An `#include` line of a source.
struct Include {
    std::size_t line = 0;  ///< from 1
    std::string path;      ///< between the quotes or brackets
    bool quoted = true;    ///< "..." rather than <...>
};

/// A source of the project: .cpp, .hpp or .h.
struct Source {
    std::string path;  ///< from the top of the tree, with '/'
    std::size_t lines = 0;
    bool guarded = false;  ///< a header that may be included twice: #pragma once, or the guard of a C header
    std::vector<Include> includes;
};

/// Reads a source from its text; `path` only names it.
Source parse_source(std::string path, std::string_view text);

/// Every source in the folders of `top`, in the order of their paths. Hidden folders and build folders are left out.
std::vector<Source> read_tree(const std::filesystem::path& top);

/// Names of the folders that stand in `top`, without hidden ones (.ci apart) and build folders.
std::set<std::string> top_folders(const std::filesystem::path& top);

}  // namespace cardioid::test
