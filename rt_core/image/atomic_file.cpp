#include "rt_core/image/atomic_file.hpp"

#include <atomic>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <unistd.h>

#include "rt_core/api/error.hpp"

namespace cardioid {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& path, int error) {
    throw Error(ErrorCode::io, fmt::format("{}: cannot write: {}", path, std::strerror(error)));
}

/// What the path stands for once links are followed.
fs::path resolved(const std::string& path) {
    std::error_code error;
    const fs::path target = fs::weakly_canonical(path, error);
    return error ? fs::path(path) : target;
}

fs::path folder_of(const fs::path& target) { return target.has_parent_path() ? target.parent_path() : fs::path("."); }

/// Writes and closes; returns errno of what failed, or 0.
int write_and_close(int file, std::span<const std::byte> bytes, bool regular) {
    int error = 0;
    while (!bytes.empty() && error == 0) {
        const ssize_t n = ::write(file, bytes.data(), bytes.size());
        if (n >= 0)
            bytes = bytes.subspan(static_cast<std::size_t>(n));
        else if (errno != EINTR)
            error = errno;
    }
    // Some file systems tell of a full disk only now.
    if (regular && error == 0 && ::fsync(file) != 0) error = errno;
    if (::close(file) != 0 && error == 0) error = errno;
    return error;
}

/// A new file in the folder, with the permissions the user's mask leaves.
int open_temporary(const fs::path& folder, fs::path& name) {
    static std::atomic<unsigned> counter{0};
    for (;;) {
        name = folder / fmt::format(".cardioid-{}-{}.tmp", ::getpid(), counter++);
        const int file = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (file >= 0 || errno != EEXIST) return file;
    }
}

}  // namespace

void write_whole_file(const std::string& path, std::span<const std::byte> bytes) {
    const fs::path target = resolved(path);
    std::error_code ignored;
    const fs::file_status status = fs::status(target, ignored);
    if (fs::is_directory(status)) fail(path, EISDIR);
    if (fs::exists(status) && !fs::is_regular_file(status)) {
        const int file = ::open(target.c_str(), O_WRONLY | O_CLOEXEC);
        if (file < 0) fail(path, errno);
        if (const int error = write_and_close(file, bytes, false)) fail(path, error);
        return;
    }
    fs::path temporary;
    const int file = open_temporary(folder_of(target), temporary);
    if (file < 0) fail(path, errno);
    int error = write_and_close(file, bytes, true);
    if (error == 0 && ::rename(temporary.c_str(), target.c_str()) != 0) error = errno;
    if (error == 0) return;
    ::unlink(temporary.c_str());
    fail(path, error);
}

void check_writable(const std::string& path) {
    const fs::path target = resolved(path);
    std::error_code ignored;
    const fs::file_status status = fs::status(target, ignored);
    if (fs::is_directory(status)) fail(path, EISDIR);
    const bool as_it_is = fs::exists(status) && !fs::is_regular_file(status);
    const fs::path asked = as_it_is ? target : folder_of(target);
    if (::access(asked.c_str(), as_it_is ? W_OK : W_OK | X_OK) != 0) fail(path, errno);
}

}  // namespace cardioid
