#pragma once
#include <string>

#include "rt_core/api/registry.hpp"
#include "rt_core/scene/scene.hpp"

namespace cardioid::test {

/// A registry with a few kinds of materials and lights that cannot be made: reading a scene makes none.
const Registry& small_registry();

/// The scene of a `.csg` text called "t.csg".
Scene read(const std::string& text, ReadOptions options = {});

/// The message of the Error that reading throws, "" where it throws none.
std::string error_of(const std::string& text, ReadOptions options = {});

/// The tree of a scene in short: "(cube-sphere)" for differences, "&" for intersections, "+" for unions, roots with
/// spaces between.
std::string tree_of(const Scene& scene);

/// All warnings in one text.
std::string warnings_of(const Scene& scene);

bool contains(const std::string& text, const std::string& part);

}  // namespace cardioid::test
