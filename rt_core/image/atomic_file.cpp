#include "rt_core/image/atomic_file.hpp"

#include <atomic>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <unistd.h>
#include <utility>

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

AtomicFile::AtomicFile(const std::string& path) : path_(path), target_(resolved(path)) {
    std::error_code ignored;
    const fs::file_status status = fs::status(target_, ignored);
    if (fs::is_directory(status)) fail(path_, EISDIR);
    if (fs::exists(status) && !fs::is_regular_file(status)) {
        file_ = ::open(target_.c_str(), O_WRONLY | O_CLOEXEC);
        if (file_ < 0) fail(path_, errno);
        return;
    }
    fs::path temporary;
    file_ = open_temporary(folder_of(target_), temporary);
    if (file_ < 0) fail(path_, errno);
    temporary_ = temporary;
}

AtomicFile::~AtomicFile() {
    if (file_ >= 0) ::close(file_);
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void AtomicFile::write(std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t n = ::write(file_, bytes.data(), bytes.size());
        if (n >= 0)
            bytes = bytes.subspan(static_cast<std::size_t>(n));
        else if (errno != EINTR)
            fail(path_, errno);
    }
}

void AtomicFile::commit() {
    // Some file systems tell of a full disk only now.
    if (!temporary_.empty() && ::fsync(file_) != 0) fail(path_, errno);
    if (::close(std::exchange(file_, -1)) != 0) fail(path_, errno);
    if (temporary_.empty()) return;
    if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail(path_, errno);
    temporary_.clear();
}

void write_whole_file(const std::string& path, std::span<const std::byte> bytes) {
    AtomicFile file(path);
    file.write(bytes);
    file.commit();
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
