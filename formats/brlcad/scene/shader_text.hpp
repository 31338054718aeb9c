#pragma once
#include <map>
#include <string>
#include <vector>

namespace cardioid::formats::brlcad {

/// A shader's name and parameters, from either way of writing them: `plastic {sh 10}` or `plastic sh=10`.
struct ShaderText {
    std::string name;                           ///< "" where nothing is said
    std::map<std::string, std::string> values;  ///< text behind each key
    std::vector<std::string> others;            ///< names of a stack that are not the surface itself

    /// The same text for both ways: name, then key=value in the order of the keys.
    [[nodiscard]] std::string plain() const;
    /// The number of the first of the keys that is given.
    [[nodiscard]] double number(std::initializer_list<const char*> keys, double fallback) const;
    /// Three numbers, however they are separated; empty where the key is not given.
    [[nodiscard]] std::vector<double> triple(const char* key) const;
};

/// Of a stack, the surface (plastic, mirror, glass, phong ...) is taken, and the others are named.
ShaderText parse_shader(const std::string& text);

}  // namespace cardioid::formats::brlcad
