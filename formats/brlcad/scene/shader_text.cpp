#include "formats/brlcad/scene/shader_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <utility>

namespace cardioid::formats::brlcad {

namespace {

constexpr std::array<std::string_view, 25> shaders{
    "plastic",   "mirror", "glass",   "phong",   "light",  "checker", "cloud", "testmap", "texture",
    "bwtexture", "stack",  "stxt",    "envmap",  "camo",   "air",     "toon",  "cook",    "flat",
    "fakestar",  "gravel", "turbump", "fbmbump", "marble", "wood",    "osl"};

bool is_shader(std::string_view word) { return std::find(shaders.begin(), shaders.end(), word) != shaders.end(); }
bool is_surface(std::string_view word) {
    return word == "plastic" || word == "mirror" || word == "glass" || word == "phong" || word == "cook";
}

/// Words; a group in braces within the parameters is one word, so that `c1 {1 2 3}` stays together.
std::vector<std::string> words_of(const std::string& text) {
    std::vector<std::string> out;
    std::string word;
    const auto end = [&] {
        if (!word.empty()) out.push_back(std::exchange(word, {}));
    };
    for (const char c : text) {
        if (c == ' ' || c == '\t' || c == '=' || c == '{' || c == '}' || c == ';' || c == '"')
            end();
        else
            word += c;
    }
    end();
    return out;
}

bool is_number(const std::string& word) {
    return !word.empty() && word.find_first_not_of("0123456789+-.eE/,") == std::string::npos;
}

}  // namespace

std::string ShaderText::plain() const {
    std::string out = name.empty() ? "plastic" : name;
    for (const std::string& other : others) out += "+" + other;
    for (const auto& [key, value] : values) out += " " + key + "=" + value;
    return out;
}

double ShaderText::number(std::initializer_list<const char*> keys, double fallback) const {
    for (const char* key : keys)
        if (const auto found = values.find(key); found != values.end()) {
            const double value = std::strtod(found->second.c_str(), nullptr);
            if (std::isfinite(value)) return value;
        }
    return fallback;
}

std::vector<double> ShaderText::triple(const char* key) const {
    const auto found = values.find(key);
    if (found == values.end()) return {};
    std::vector<double> out;
    const char* at = found->second.c_str();
    while (*at && out.size() < 3) {
        char* next = nullptr;
        const double value = std::strtod(at, &next);
        if (next == at) {
            ++at;
        } else {
            out.push_back(std::isfinite(value) ? value : 0);
            at = next;
        }
    }
    if (out.size() == 1) out.resize(3, out[0]);
    return out.size() == 3 ? out : std::vector<double>{};
}

ShaderText parse_shader(const std::string& text) {
    const std::vector<std::string> words = words_of(text);
    ShaderText out;
    std::string current;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string& word = words[i];
        if (i == 0 || is_shader(word)) {
            current = word;
            const bool replaces = out.name.empty() || out.name == "stack" || out.name == "envmap" ||
                                  (is_surface(word) && !is_surface(out.name));
            if (out.name == "envmap" || (!replaces && word != out.name)) {
                out.others.push_back(word);
                continue;
            }
            if (!out.name.empty() && out.name != "stack" && out.name != word) out.others.push_back(out.name);
            out.name = word;
            continue;
        }
        std::string value;
        while (i + 1 < words.size() && is_number(words[i + 1])) value += (value.empty() ? "" : " ") + words[++i];
        if (value.empty() && i + 1 < words.size() && !is_shader(words[i + 1])) value = words[++i];
        out.values.emplace(word, value);
    }
    return out;
}

}  // namespace cardioid::formats::brlcad
