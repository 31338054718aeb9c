#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fmt/format.h>

#include "cli/compare/figures_json.hpp"
#include "cli/compare/report_template.hpp"
#include "cli/compare/verdict.hpp"
#include "rt_core/image/half.hpp"

namespace cardioid::cli {
namespace {

using Json = nlohmann::ordered_json;

std::string base64(const std::vector<std::uint8_t>& bytes) {
    static constexpr char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const auto at = [&](std::size_t k) { return i + k < bytes.size() ? std::uint32_t{bytes[i + k]} : 0U; };
        const std::uint32_t three = at(0) << 16 | at(1) << 8 | at(2);
        for (std::size_t k = 0; k < 4; ++k) text += k > bytes.size() - i ? '=' : letters[three >> (18 - 6 * k) & 63];
    }
    return text;
}

std::string pixels(const Picture& picture) {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(picture.pixels.size() * 6);
    for (const Rgb& p : picture.pixels)
        for (const float x : {p.r, p.g, p.b}) {
            const std::uint16_t half = to_half(x);
            bytes.push_back(static_cast<std::uint8_t>(half & 0xFF));
            bytes.push_back(static_cast<std::uint8_t>(half >> 8));
        }
    return base64(bytes);
}

std::string flip_pixels(const std::vector<float>& flip) {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(flip.size());
    for (const float x : flip) bytes.push_back(static_cast<std::uint8_t>(std::lround(255 * std::clamp(x, 0.0F, 1.0F))));
    return base64(bytes);
}

}  // namespace

std::string report_page(const Picture& a, const Picture& b, const Comparison& comparison, const Verdict& verdict,
                        const CompareOptions& options) {
    const auto name = [](const Picture& p) { return std::filesystem::path(p.path).filename().string(); };
    Json figures = Json::array({figures_json(comparison.whole)});
    for (const RegionFigures& region : comparison.regions) figures.push_back(figures_json(region));
    const Json data{{"title", fmt::format("{} and {}", name(a), name(b))},
                    {"width", a.width},
                    {"height", a.height},
                    {"exposure", options.settings.exposure},
                    {"verdict", {{"text", verdict.text}, {"good", verdict.good}}},
                    {"checks", checks_json(verdict)},
                    {"figures", figures},
                    {"a", {{"name", name(a)}, {"pixels", pixels(a)}}},
                    {"b", {{"name", name(b)}, {"pixels", pixels(b)}}},
                    {"flip", flip_pixels(comparison.flip)}};
    // A name with "</script>" in it must not end the script.
    std::string text = data.dump();
    for (std::size_t at = 0; (at = text.find("</", at)) != std::string::npos; at += 3) text.replace(at, 2, "<\\/");
    std::string page = report_template;
    constexpr std::string_view place = "/*DATA*/null";
    return page.replace(page.find(place), place.size(), text);
}

}  // namespace cardioid::cli
