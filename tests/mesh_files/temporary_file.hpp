#pragma once
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <unistd.h>

namespace cardioid::test {

/// A file that is gone with the object. `name` gives it its extension.
class TemporaryFile {
public:
    TemporaryFile(const std::string& name, std::string_view bytes)
        : path_(std::filesystem::temp_directory_path() / ("cardioid_" + std::to_string(::getpid()) + "_" + name)) {
        std::ofstream(path_, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    }
    ~TemporaryFile() {
        std::error_code ignored;
        std::filesystem::remove(path_, ignored);
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    [[nodiscard]] std::string path() const { return path_.string(); }

private:
    std::filesystem::path path_;
};

}  // namespace cardioid::test
