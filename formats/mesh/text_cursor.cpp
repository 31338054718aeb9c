#include "formats/mesh/text_cursor.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "rt_core/api/error.hpp"

namespace cardioid::formats {

namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }
bool ends_word(char c) { return is_blank(c) || c == '\n'; }

}  // namespace

std::string quoted(std::string_view word) {
    constexpr std::size_t longest = 40;
    std::string out = "\"";
    for (const char c : word.substr(0, longest)) out += c >= ' ' && c <= '~' ? c : '?';
    return out + (word.size() > longest ? "...\"" : "\"");
}

void TextCursor::skip_blanks() {
    while (!rest_.empty() && is_blank(rest_[0])) rest_.remove_prefix(1);
}

std::string_view TextCursor::take_word() {
    const auto end = std::ranges::find_if(rest_, ends_word);
    const std::string_view out = rest_.substr(0, static_cast<std::size_t>(end - rest_.begin()));
    rest_.remove_prefix(out.size());
    return out;
}

std::string_view TextCursor::word() {
    for (skip_blanks(); !rest_.empty() && rest_[0] == '\n'; skip_blanks()) {
        ++line_;
        rest_.remove_prefix(1);
    }
    return take_word();
}

std::string_view TextCursor::word_in_line() {
    for (skip_blanks(); !rest_.empty() && rest_[0] == '\\'; skip_blanks()) {
        const std::size_t newline = rest_.starts_with("\\\r\n") ? 2 : 1;
        if (rest_.size() <= newline || rest_[newline] != '\n') break;
        rest_.remove_prefix(newline + 1);
        ++line_;
    }
    if (rest_.empty() || rest_[0] == '\n') return {};
    return take_word();
}

void TextCursor::skip_line() {
    const std::size_t end = rest_.find('\n');
    if (end == std::string_view::npos) {
        rest_ = {};
        return;
    }
    rest_.remove_prefix(end + 1);
    ++line_;
}

double TextCursor::number() { return number(word()); }

double TextCursor::number(std::string_view word, std::string_view wanted) const {
    const std::string_view digits = word.starts_with('+') ? word.substr(1) : word;
    double out = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), out);
    // Below the least double is 0; from_chars says the same of what is above the greatest.
    if (error == std::errc::result_out_of_range && end == digits.data() + digits.size()) {
        const std::size_t exponent = digits.find_first_of("eE");
        if (exponent != std::string_view::npos && digits.substr(exponent + 1).starts_with('-')) return 0;
    }
    if (error != std::errc() || end != digits.data() + digits.size()) fail(word, wanted);
    if (!std::isfinite(out)) fail(word, "a finite number");
    return out;
}

std::int64_t TextCursor::integer(std::string_view word, std::string_view wanted) const {
    const std::string_view digits = word.starts_with('+') ? word.substr(1) : word;
    std::int64_t out = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), out);
    if (error != std::errc() || end != digits.data() + digits.size()) fail(word, wanted);
    return out;
}

void TextCursor::fail(std::string_view found, std::string_view wanted) const { fail_at(line_, found, wanted); }

void TextCursor::fail_at(std::size_t line, std::string_view found, std::string_view wanted) const {
    const std::string what = !found.empty()  ? quoted(found)
                             : rest_.empty() ? "the end of the file"
                                             : "the end of the line";
    throw Error(ErrorCode::bad_input,
                file_ + ":" + std::to_string(line) + ": found " + what + ", wanted " + std::string(wanted));
}

}  // namespace cardioid::formats
