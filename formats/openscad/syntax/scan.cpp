#include "formats/openscad/syntax/scan.hpp"

#include <algorithm>
#include <charconv>

namespace cardioid::formats::openscad {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_word(char c) { return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

std::size_t digits_at(std::string_view s, std::size_t i) {
    const std::size_t start = i;
    while (i < s.size() && is_digit(s[i])) ++i;
    return i - start;
}

}  // namespace

std::size_t identifier_length(std::string_view s) {
    std::size_t i = !s.empty() && s[0] == '$' ? 1 : 0;
    const std::size_t start = i;
    while (i < s.size() && is_word(s[i])) ++i;
    return i > start ? i : 0;
}

std::size_t number_length(std::string_view s) {
    const std::size_t whole = digits_at(s, 0);
    std::size_t i = whole;
    if (i < s.size() && s[i] == '.') {
        const std::size_t fraction = digits_at(s, i + 1);
        if (whole + fraction > 0) i += 1 + fraction;
    }
    if (i == 0) return 0;
    if (i < s.size() && (s[i] == 'e' || s[i] == 'E')) {
        const std::size_t sign = i + 1 < s.size() && (s[i + 1] == '+' || s[i + 1] == '-') ? 1 : 0;
        const std::size_t exponent = digits_at(s, i + 1 + sign);
        if (exponent > 0) i += 1 + sign + exponent;
    }
    return i;
}

bool is_huge(std::string_view number) {
    const std::size_t e = std::min(number.find_first_of("eE"), number.size());
    const std::size_t point = std::min(number.find('.'), e);
    const std::size_t first = std::min(number.find_first_of("123456789"), e);
    if (first >= e) return false;
    const auto place = static_cast<double>(point) - static_cast<double>(first);  // of the first digit that counts
    if (e == number.size()) return place > 0;
    std::string_view digits = number.substr(e + 1);
    const bool negative = digits.starts_with('-');
    if (negative || digits.starts_with('+')) digits.remove_prefix(1);
    double exponent = 1e30;  // where it does not fit an integer
    std::int64_t value = 0;
    if (std::from_chars(digits.data(), digits.data() + digits.size(), value).ec == std::errc{})
        exponent = static_cast<double>(value);
    return place + (negative ? -exponent : exponent) > 0;
}

bool is_long_fraction(std::string_view number) {
    constexpr int openscad_digits = 6;
    const std::size_t e = std::min(number.find_first_of("eE"), number.size());
    const std::string_view mantissa = number.substr(0, e);
    if (e == number.size() && mantissa.find('.') == std::string_view::npos) return false;
    int digits = 0, zeros = 0;
    for (const char c : mantissa) {
        if (c == '.') continue;
        if (c == '0') {
            if (digits > 0) ++zeros;  // counts only where another digit follows
        } else {
            digits += 1 + zeros, zeros = 0;
        }
    }
    return digits > openscad_digits;
}

std::size_t character_length(std::string_view s) {
    const auto lead = static_cast<unsigned char>(s[0]);
    const std::size_t length = lead < 0xC0 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : lead < 0xF8 ? 4 : 1;
    if (length > s.size()) return 1;
    for (std::size_t i = 1; i < length; ++i)
        if ((static_cast<unsigned char>(s[i]) & 0xC0U) != 0x80U) return 1;
    return length;
}

void append_utf8(std::string& out, std::uint32_t code) {
    if (code > 0x10FFFFU || (code >= 0xD800U && code < 0xE000U)) code = 0xFFFD;
    const auto put = [&](std::uint32_t byte) { out.push_back(static_cast<char>(byte)); };
    if (code < 0x80U) return put(code);
    if (code < 0x800U) {
        put(0xC0U | (code >> 6U));
    } else if (code < 0x10000U) {
        put(0xE0U | (code >> 12U));
        put(0x80U | ((code >> 6U) & 0x3FU));
    } else {
        put(0xF0U | (code >> 18U));
        put(0x80U | ((code >> 12U) & 0x3FU));
        put(0x80U | ((code >> 6U) & 0x3FU));
    }
    put(0x80U | (code & 0x3FU));
}

}  // namespace cardioid::formats::openscad
