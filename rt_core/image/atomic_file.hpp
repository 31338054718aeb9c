#pragma once
#include <cstddef>
#include <span>
#include <string>

namespace cardioid {

/// Writes a file whole or not at all: into a temporary file beside it, then renamed over it. A link is followed; a
/// device or pipe is written to as it is. Throws Error(io) and leaves the old file as it was, also on a full disk.
void write_whole_file(const std::string& path, std::span<const std::byte> bytes);

/// Throws Error(io) where `path` is a folder, or its folder is missing or closed to us.
void check_writable(const std::string& path);

}  // namespace cardioid
