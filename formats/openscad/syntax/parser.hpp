#pragma once
#include <string>
#include <string_view>

#include "formats/openscad/syntax/ast.hpp"

namespace cardioid::formats::openscad {

/// Statements (unless told otherwise) and lists may be nested this deep.
inline constexpr std::size_t nesting_limit = 100'000;

/// Parses a `.csg` text. Needs no stack for nesting and time in proportion to the text. Throws Error(bad_input) with
/// file:line:column, what was found, what was wanted; of an OpenSCAD program, the command that evaluates it.
Ast parse(std::string_view text, std::string file, std::size_t most_nested = nesting_limit);

/// Parses the call inside a marker `%text(text = "@cardioid <text>")`: strings may stand in single quotes.
/// where: file:line:column of the marker, for messages.
Ast parse_marker(std::string_view text, std::string where);

}  // namespace cardioid::formats::openscad
