#pragma once
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cardioid::formats {

/// A file in a ZIP archive.
struct ZipEntry {
    std::string name;
    std::size_t offset = 0;  ///< of its local header
    std::size_t packed = 0, size = 0;
    int method = 0;  ///< 0 stored, 8 deflated
};

/// The archive's directory. Throws Error(bad_input) where there is none.
std::vector<ZipEntry> zip_entries(std::string_view archive, const std::string& file);

/// An entry's content. Throws Error(bad_input) where it is damaged, Error(limit) past 4 GB.
std::string unzip(std::string_view archive, const ZipEntry& entry, const std::string& file);

/// An archive of named contents, deflated. Throws Error(limit) past 4 GB.
std::string zip(const std::vector<std::pair<std::string, std::string>>& files);

}  // namespace cardioid::formats
