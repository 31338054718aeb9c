#pragma once
#include <string_view>
#include <vector>

#include "formats/openscad/syntax/ast.hpp"

namespace cardioid::formats::openscad {

/// For each call, the call `%text(text = "@cardioid ...")` that it stands for: itself, or the only thing in a chain of
/// groups of one child; no_marker for every other call. In time proportional to the tree.
std::vector<std::uint32_t> find_markers(const Ast& ast);
inline constexpr std::uint32_t no_marker = 0xFFFFFFFFU;

/// What follows "@cardioid " in the text of a marker; empty for any other call.
std::string_view marker_text(const Ast& ast, const Call& call);

}  // namespace cardioid::formats::openscad
