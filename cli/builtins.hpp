#pragma once
#include <memory>
#include <string>
#include <vector>

#include "rt_core/api/registry.hpp"

namespace cardioid::cli {

/// The registry with all that is built in, then what CARDIOID_PLUGIN_PATH and `plugins` bring. Throws Error.
std::unique_ptr<Registry> open_registry(const std::vector<std::string>& plugins);

}  // namespace cardioid::cli
