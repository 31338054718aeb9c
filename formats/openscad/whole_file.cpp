#include "formats/openscad/whole_file.hpp"

#include "formats/openscad/evaluate/call_table.hpp"

namespace cardioid::formats::openscad {

std::uint32_t root_modifier(const Ast& ast) {
    for (std::uint32_t i = 0; i < ast.calls.size(); ++i)
        if ((ast.calls[i].modifiers & Modifier::only) != 0) return i;
    return no_call;
}

bool has_long_numbers(const Ast& ast) {
    for (const Call& call : ast.calls) {
        const CallInfo* info = find_call(ast.name(call));
        if (!info || is_setting(info->node)) continue;
        for (const Argument& argument : ast.arguments_of(call))
            if (argument.long_numbers) return true;
    }
    return false;
}

}  // namespace cardioid::formats::openscad
