#pragma once
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace cardioid::test {

/// All bytes of a file, "" where it cannot be read.
inline std::string file_text(const std::filesystem::path& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return std::move(text).str();
}

}  // namespace cardioid::test
