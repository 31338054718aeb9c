#include "formats/brlcad/read/line_reader.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>

#include "rt_core/api/error.hpp"

namespace cardioid::formats::brlcad {

namespace {

constexpr const char* blank = " \t\r";

std::string_view shortened(std::string_view word) { return word.substr(0, 40); }

}  // namespace

bool LineReader::next_line() {
    if (next_ >= text_.size()) return false;
    const std::size_t end = std::min(text_.find('\n', next_), text_.size());
    line_ = text_.substr(next_, end - next_);
    if (line_.ends_with('\r')) line_.remove_suffix(1);
    next_ = end + 1;
    column_ = word_column_ = 0;
    ++number_;
    return true;
}

bool LineReader::next_record() {
    while (next_line()) {
        const std::size_t start = line_.find_first_not_of(blank);
        if (start != std::string_view::npos && line_[start] != '#') return true;
    }
    return false;
}

std::optional<std::string_view> LineReader::word() {
    const std::size_t start = line_.find_first_not_of(blank, column_);
    if (start == std::string_view::npos) {
        word_column_ = column_ = line_.size();
        return std::nullopt;
    }
    const std::size_t end = std::min(line_.find_first_of(blank, start), line_.size());
    word_column_ = start;
    column_ = end;
    return line_.substr(start, end - start);
}

std::string_view LineReader::wanted_word(const char* what) {
    if (const auto found = word()) return *found;
    fail(fmt::format("found the end of the line, wanted {}", what));
}

double LineReader::number(const char* what) {
    const std::string_view text = wanted_word(what);
    const std::string_view digits = text.starts_with('+') ? text.substr(1) : text;
    double value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (end != digits.data() + digits.size() || digits.empty() || error == std::errc::invalid_argument ||
        !std::isfinite(value))
        fail(fmt::format("found \"{}\", wanted {}, a number", shortened(text), what));
    return error == std::errc::result_out_of_range ? 0 : value;
}

long LineReader::whole(const char* what) {
    const std::string_view text = wanted_word(what);
    long value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size())
        fail(fmt::format("found \"{}\", wanted {}, a whole number", shortened(text), what));
    return value;
}

long LineReader::whole_or(const char* what, long fallback) {
    const std::size_t before = column_;
    if (!word()) return fallback;
    column_ = before;
    return whole(what);
}

std::string LineReader::place() const { return fmt::format("{}:{}:{}", *file_, number_, word_column_ + 1); }

void LineReader::fail(const std::string& what) const { throw Error(ErrorCode::bad_input, place() + ": " + what); }

}  // namespace cardioid::formats::brlcad
