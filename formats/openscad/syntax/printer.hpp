#pragma once
#include <string>

#include "formats/openscad/syntax/ast.hpp"

namespace cardioid::formats::openscad {

/// The tree in OpenSCAD's own layout: parse(print(ast)) is equal to ast. Numbers have as many digits as bring the same
/// double back.
std::string print(const Ast& ast);

}  // namespace cardioid::formats::openscad
