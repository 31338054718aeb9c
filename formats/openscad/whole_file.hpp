#pragma once
#include "formats/openscad/syntax/ast.hpp"

namespace cardioid::formats::openscad {

inline constexpr std::uint32_t no_call = 0xFFFFFFFFU;

/// The first call marked `!`, which alone is the model, or no_call.
std::uint32_t root_modifier(const Ast& ast);

/// Whether a call that OpenSCAD writes has a fraction of more than the 6 digits that it prints.
bool has_long_numbers(const Ast& ast);

}  // namespace cardioid::formats::openscad
