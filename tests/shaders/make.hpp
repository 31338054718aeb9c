#pragma once
#include <map>
#include <memory>
#include <stdexcept>
#include <string>

#include "shaders/builtins.hpp"

namespace cardioid::test {

inline ParamValue list(std::vector<double> numbers) { return {.numbers = std::move(numbers), .list = true}; }
inline ParamValue number(double x) { return {.numbers = {x}}; }
inline ParamValue text(std::string t) { return {.kind = ParamValue::Kind::text, .text = std::move(t)}; }
inline ParamValue truth(bool b) { return {.kind = ParamValue::Kind::boolean, .boolean = b}; }

using Values = std::map<std::string, ParamValue>;

inline Params params(const Values& values) {
    Params out("scene.csg:3:7");
    for (const auto& [name, value] : values) out.set(name, value);
    return out;
}

inline std::shared_ptr<const Shader> make_shader(const std::string& kind, const Values& values = {}) {
    const Params given = params(values);
    for (const ShaderKind& k : shaders::builtin_shaders())
        if (k.name == kind) return k.make({given, {}});
    throw std::logic_error("no shader " + kind);
}

inline std::unique_ptr<Light> make_light(const std::string& kind, const Values& values = {},
                                         const Affine& to_world = {}, const std::string& base_dir = {}) {
    const Params given = params(values);
    for (const LightKind& k : shaders::builtin_lights())
        if (k.name == kind) return k.make({given, to_world, base_dir});
    throw std::logic_error("no light " + kind);
}

/// The message of the Error(bad_input) that making it throws, or "" where it throws none.
template <class Make>
std::string error_of(Make&& make) {
    try {
        make();
    } catch (const Error& e) {
        return e.code() == ErrorCode::bad_input ? e.what() : "wrong code: " + std::string(e.what());
    }
    return "";
}

}  // namespace cardioid::test
