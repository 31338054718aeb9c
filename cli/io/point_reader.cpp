#include "cli/io/point_reader.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include "cli/terminal/interrupt.hpp"
#include "rt_core/api/error.hpp"

namespace cardioid::cli {
namespace {

constexpr std::size_t read_bytes = 1 << 18, longest_line = 1 << 16;
constexpr std::string_view between = " \t,\r\v\f";
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

struct Place {
    const std::string& file;
    std::uint64_t line;
    [[noreturn]] void refuse(std::size_t column, const std::string& text) const {
        throw Error(ErrorCode::bad_input, fmt::format("{}:{}:{}: {}", file, line, column + 1, text));
    }
};

/// As much of a word as fits into a message.
std::string shown(std::string_view word) {
    constexpr std::size_t most = 40;
    std::string text(word.substr(0, most));
    for (char& c : text)
        if (std::iscntrl(static_cast<unsigned char>(c))) c = '?';
    return text + (word.size() > most ? "..." : "");
}

double number(std::string_view word, std::size_t column, const Place& place) {
    const std::string_view digits = word.starts_with('+') ? word.substr(1) : word;
    double value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc{} || end != digits.data() + digits.size() || !std::isfinite(value))
        place.refuse(column, fmt::format("found \"{}\", wanted a number", shown(word)));
    return value;
}

[[noreturn]] void cannot_read(const std::string& name, int error) {
    throw Error(ErrorCode::io, fmt::format("{}: cannot be read: {}", name, std::strerror(error)));
}

}  // namespace

std::optional<ProbePoint> parse_point(std::string_view text, const std::string& file, std::uint64_t line) {
    const Place place{file, line};
    text = text.substr(0, text.find('#'));
    double v[6] = {};
    std::size_t count = 0, begin = text.find_first_not_of(between), direction = 0;
    for (; begin != std::string_view::npos; ++count) {
        const std::size_t end = std::min(text.find_first_of(between, begin), text.size());
        if (count == 6)
            place.refuse(begin, fmt::format("found \"{}\" after six numbers, wanted x y z nx ny nz",
                                            shown(text.substr(begin, end - begin))));
        if (count == 3) direction = begin;
        v[count] = number(text.substr(begin, end - begin), begin, place);
        begin = text.find_first_not_of(between, end);
    }
    if (count == 0) return std::nullopt;
    if (count < 6)
        place.refuse(text.size(),
                     fmt::format("found {} number{}, wanted six: x y z nx ny nz", count, count == 1 ? "" : "s"));
    if (v[3] == 0 && v[4] == 0 && v[5] == 0) place.refuse(direction, "found 0 0 0, wanted a direction nx ny nz");
    return ProbePoint{{v[0], v[1], v[2]}, {v[3], v[4], v[5]}};
}

PointReader::PointReader(const std::string& file) : file_(file), name_(file == "-" ? "<stdin>" : file) {
    descriptor_ = file == "-" ? STDIN_FILENO : ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor_ < 0) cannot_read(name_, errno);
    struct stat status {};
    if (::fstat(descriptor_, &status) == 0 && S_ISDIR(status.st_mode)) {
        if (file != "-") ::close(descriptor_);
        cannot_read(name_, EISDIR);
    }
}

PointReader::~PointReader() {
    if (file_ != "-") ::close(descriptor_);
}

bool PointReader::read(std::vector<ProbePoint>& points) {
    points.clear();
    while (points.empty() && !ended_) {
        fill();
        take_lines(points);
    }
    return !points.empty();
}

void PointReader::fill() {
    pollfd wait{descriptor_, POLLIN, 0};
    // Of the two, only poll() returns when the user interrupts.
    while (::poll(&wait, 1, -1) < 0)
        if (errno != EINTR || interrupted()) {
            ended_ = true;
            text_.clear();
            return;
        }
    const std::size_t before = text_.size();
    text_.resize(before + read_bytes);
    const ssize_t n = ::read(descriptor_, text_.data() + before, read_bytes);
    if (n < 0 && errno != EINTR) cannot_read(name_, errno);
    text_.resize(before + static_cast<std::size_t>(std::max<ssize_t>(n, 0)));
    if (n != 0) return;
    ended_ = true;
    if (!text_.empty()) text_ += '\n';
}

void PointReader::take_lines(std::vector<ProbePoint>& points) {
    std::size_t begin = 0;
    for (std::size_t end; (end = text_.find('\n', begin)) != std::string::npos; begin = end + 1) {
        std::string_view line = std::string_view(text_).substr(begin, end - begin);
        if (++line_ == 1 && line.starts_with(byte_order_mark)) line.remove_prefix(byte_order_mark.size());
        if (const auto point = parse_point(line, name_, line_)) points.push_back(*point);
    }
    text_.erase(0, begin);
    if (text_.size() > longest_line)
        Place{name_, line_ + 1}.refuse(longest_line, "found a line without end, wanted x y z nx ny nz");
}

std::optional<std::uint64_t> count_points(const std::string& file) {
    struct stat status {};
    if (file == "-" || (::stat(file.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode)))
        return std::nullopt;
    PointReader reader(file);
    std::uint64_t count = 0;
    for (std::vector<ProbePoint> points; reader.read(points);) count += points.size();
    return count;
}

}  // namespace cardioid::cli
