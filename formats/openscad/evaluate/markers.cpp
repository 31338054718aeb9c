#include "formats/openscad/evaluate/markers.hpp"

namespace cardioid::formats::openscad {

std::string_view marker_text(const Ast& ast, const Call& call) {
    constexpr std::string_view prefix = "@cardioid ";
    if (ast.name(call) != "text" || (call.modifiers & Modifier::background) == 0) return {};
    for (const Argument& argument : ast.arguments_of(call)) {
        if (argument.value.kind != ValueKind::text) continue;
        if (argument.name != Argument::no_name && ast.texts[argument.name] != "text") continue;
        const std::string_view text = ast.texts[argument.value.first];
        return text.starts_with(prefix) ? text.substr(prefix.size()) : std::string_view{};
    }
    return {};
}

std::vector<std::uint32_t> find_markers(const Ast& ast) {
    std::vector<std::uint32_t> out(ast.calls.size(), no_marker);
    for (std::size_t i = ast.calls.size(); i-- > 0;) {  // children stand behind their parents
        const Call& call = ast.calls[i];
        if (!marker_text(ast, call).empty())
            out[i] = static_cast<std::uint32_t>(i);
        else if (call.child_count == 1 && call.modifiers == 0 && ast.name(call) == "group")
            out[i] = out[ast.children[call.first_child]];
    }
    return out;
}

}  // namespace cardioid::formats::openscad
