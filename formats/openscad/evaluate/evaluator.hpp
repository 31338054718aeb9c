#pragma once
#include "formats/openscad/syntax/ast.hpp"
#include "rt_core/api/format.hpp"
#include "rt_core/scene/scene.hpp"

namespace cardioid::formats::openscad {

/// What a parsed file means, with the booleans of OpenSCAD 2021.01: solids as leaves under flat trees, plane figures
/// evaluated. base_dir: for relative files. Needs no stack for nesting. Throws Error with file:line:column.
Scene evaluate(const Ast& ast, const ReadOptions& options, const std::string& base_dir);

}  // namespace cardioid::formats::openscad
