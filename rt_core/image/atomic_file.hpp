#pragma once
#include <cstddef>
#include <span>
#include <string>

namespace cardioid {

/// A file that appears whole or not at all: written into a temporary file beside it, then renamed over it. A link is
/// followed; a device or pipe is written to as it is. Everything throws Error(io) where it cannot be done.
class AtomicFile {
public:
    explicit AtomicFile(const std::string& path);
    /// Without commit() the old file stays as it was.
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    void write(std::span<const std::byte> bytes);
    /// Puts the file into its place; nothing can be written after it.
    void commit();

private:
    std::string path_, target_, temporary_;  ///< temporary_ is empty for devices
    int file_ = -1;
};

/// The same of bytes that are there already; the old file stays as it was also on a full disk. Throws Error(io).
void write_whole_file(const std::string& path, std::span<const std::byte> bytes);

/// Throws Error(io) where `path` is a folder, or its folder is missing or closed to us.
void check_writable(const std::string& path);

}  // namespace cardioid
