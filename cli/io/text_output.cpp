#include "cli/io/text_output.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fmt/format.h>
#include <span>

#include "rt_core/api/error.hpp"
#include "rt_core/image/atomic_file.hpp"

namespace cardioid::cli {

void check_text_path(const std::string& path) {
    if (path != "-") check_writable(path);
}

void write_text(const std::string& path, const std::string& text) {
    if (path == "-") return print_text(text);
    write_whole_file(path, std::as_bytes(std::span(text)));
}

void print_text(const std::string& text) {
    errno = 0;
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
        throw Error(ErrorCode::io,
                    fmt::format("standard output: cannot write: {}", std::strerror(errno ? errno : EIO)));
}

}  // namespace cardioid::cli
