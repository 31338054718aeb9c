#include "cli/options/values.hpp"

#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <optional>

#include "rt_core/api/error.hpp"
#include "rt_core/scene/nearest_name.hpp"

namespace cardioid::cli {
namespace {

[[noreturn]] void refuse(std::string_view option, std::string_view found, std::string_view wanted) {
    throw Error(ErrorCode::usage, fmt::format("{}: found \"{}\", wanted {}", option, found, wanted));
}

template <class Number>
std::optional<Number> parsed(std::string_view text) {
    if (text.starts_with('+')) text.remove_prefix(1);
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

std::optional<double> finite(std::string_view text) {
    const auto value = parsed<double>(text);
    return value && std::isfinite(*value) ? value : std::nullopt;
}

template <class Number>
std::string range(std::string_view what, Number lo, Number hi) {
    constexpr Number least = std::numeric_limits<Number>::lowest(), most = std::numeric_limits<Number>::max();
    if (lo > least && hi < most) return fmt::format("{} from {} to {}", what, lo, hi);
    if (lo > least) return fmt::format("{} of at least {}", what, lo);
    if (hi < most) return fmt::format("{} of at most {}", what, hi);
    return std::string(what);
}

}  // namespace

double to_number(std::string_view option, std::string_view text, double lo, double hi) {
    const auto value = finite(text);
    if (!value || *value < lo || *value > hi) refuse(option, text, range("a number", lo, hi));
    return *value;
}

std::int64_t to_integer(std::string_view option, std::string_view text, std::int64_t lo, std::int64_t hi) {
    const auto value = parsed<std::int64_t>(text);
    if (!value || *value < lo || *value > hi) refuse(option, text, range("a whole number", lo, hi));
    return *value;
}

std::int64_t to_count(std::string_view option, std::string_view text) {
    constexpr std::string_view wanted = "a whole number from 1 to 1e15, as 20000, 1e8, 500k or 2.5M";
    constexpr double most = 1e15;  // still exact as a double
    const char last = text.empty() ? ' ' : text.back();
    const double unit = last == 'k' ? 1e3 : last == 'M' ? 1e6 : last == 'G' ? 1e9 : 1;
    const auto value = finite(unit > 1 ? text.substr(0, text.size() - 1) : text);
    // 2.3M is not quite 2300000 as a product of doubles.
    const double count = value ? std::round(*value * unit) : 0;
    if (count < 1 || count > most || std::abs(*value * unit - count) > 1e-9 * count) refuse(option, text, wanted);
    return static_cast<std::int64_t>(count);
}

std::vector<double> to_numbers(std::string_view option, std::string_view text, std::size_t count,
                               std::string_view wanted) {
    std::string_view inner = text;
    if (inner.size() >= 2 && inner.front() == '[' && inner.back() == ']') inner = inner.substr(1, inner.size() - 2);
    std::vector<double> numbers;
    for (const std::string& word : to_list(inner)) {
        const auto value = finite(word);
        if (!value) refuse(option, text, wanted);
        numbers.push_back(*value);
    }
    if (numbers.size() != count) refuse(option, text, wanted);
    return numbers;
}

Vec3d to_vector(std::string_view option, std::string_view text) {
    const std::vector<double> v = to_numbers(option, text, 3, "three numbers x,y,z");
    return {v[0], v[1], v[2]};
}

std::array<int, 2> to_size(std::string_view option, std::string_view text) {
    constexpr std::string_view wanted = "WxH in pixels, as 800x600, or one number for a square";
    const std::size_t cross = text.find_first_of("xX");
    const auto width = parsed<int>(text.substr(0, cross));
    const auto height = cross == std::string_view::npos ? width : parsed<int>(text.substr(cross + 1));
    if (!width || !height || *width < 1 || *height < 1) refuse(option, text, wanted);
    return {*width, *height};
}

double to_seconds(std::string_view option, std::string_view text) {
    constexpr std::string_view wanted = "a time, as 30s, 2m or 1.5h";
    if (text.empty()) refuse(option, text, wanted);
    const double unit = text.ends_with('h') ? 3600 : text.ends_with('m') ? 60 : 1;
    const auto value = finite(std::isalpha(static_cast<unsigned char>(text.back())) && (unit > 1 || text.ends_with('s'))
                                  ? text.substr(0, text.size() - 1)
                                  : text);
    if (!value || *value <= 0) refuse(option, text, wanted);
    return *value * unit;
}

double to_share(std::string_view option, std::string_view text) {
    const bool percent = text.ends_with('%');
    const auto value = finite(percent ? text.substr(0, text.size() - 1) : text);
    const double share = value ? *value * (percent ? 0.01 : 1) : 0;
    if (share <= 0 || share >= 1) refuse(option, text, "a share between 0 and 1, as 2% or 0.02");
    return share;
}

std::vector<std::string> to_list(std::string_view text) {
    std::vector<std::string> words;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        std::string_view word = text.substr(begin, end - begin);
        while (word.starts_with(' ')) word.remove_prefix(1);
        while (word.ends_with(' ')) word.remove_suffix(1);
        words.emplace_back(word);
        begin = end + 1;
    }
    return words;
}

bool to_boolean(std::string_view option, std::string_view text) {
    if (text == "true" || text == "on" || text == "yes" || text == "1") return true;
    if (text == "false" || text == "off" || text == "no" || text == "0") return false;
    refuse(option, text, "true or false");
}

std::string either(std::span<const std::string> choices) {
    std::string text;
    for (std::size_t i = 0; i < choices.size(); ++i)
        text += (i == 0 ? "" : i + 1 == choices.size() ? " or " : ", ") + choices[i];
    return text;
}

std::string suggestion(std::string_view name, std::span<const std::string> choices) {
    const std::vector<std::string_view> views(choices.begin(), choices.end());
    return did_you_mean(name, views);
}

std::string to_choice(std::string_view option, std::string_view text, std::span<const std::string> choices) {
    for (const std::string& choice : choices)
        if (choice == text) return choice;
    refuse(option, text, either(choices) + suggestion(text, choices));
}

}  // namespace cardioid::cli
