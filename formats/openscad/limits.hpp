#pragma once
#include <cstddef>
#include <span>

#include "rt_core/api/format.hpp"
#include "rt_core/api/params.hpp"

namespace cardioid::formats::openscad {

/// How much a single call may make before the scene is refused: a slip of a digit shall end in a message, not in a
/// machine without memory. Raised by `--set csg.NAME=VALUE`.
struct Limits {
    double minkowski = 5e7;        ///< sums of corners of one minkowski()
    double triangles = 5e7;        ///< of one linear_extrude()
    double cells = 5e7;            ///< of the height map of one surface()
    std::size_t nesting = 100000;  ///< calls inside one another
};

/// Name, value by itself and meaning of each, for `cardioid list options`.
std::span<const ParamSpec> limit_specs();

/// The limits by themselves but for what ReadOptions::settings says. Throws Error(usage) for an unknown name, with the
/// nearest, and for a value that is no number of at least 1.
Limits limits_of(const ReadOptions& options);

}  // namespace cardioid::formats::openscad
