#pragma once
#include <memory>
#include <string>
#include <vector>

#include "rt_core/api/registry.hpp"

namespace cardioid {

/// The program's registry, empty; cli/builtins.cpp fills it.
std::unique_ptr<Registry> make_registry();

/// Loads the shared object at `path` (a path with a slash; never searched for), checks its ABI before anything else is
/// called, lets it register its hooks; it is never unloaded. Throws Error(io, usage) with both ABI numbers on a
/// mismatch.
void load_plugin(const std::string& path, Registry& registry);

/// Loads every shared object in the folders of CARDIOID_PLUGIN_PATH (absolute folders, ':' between), in name order.
void load_plugin_path(Registry& registry);

}  // namespace cardioid
