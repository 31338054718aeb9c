#pragma once
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "rt_core/api/lighting.hpp"
#include "rt_core/render/committed_scene.hpp"

namespace cardioid::test {

/// Every built-in hook that light needs.
const Registry& hooks();

/// A scene file of samples/ with its parameters changed: each text of `change` must stand in the file and is replaced
/// wherever it does. Throws Error(bad_input) where it does not, or where reading the scene gives a warning.
Scene sample_scene(const std::string& file, const std::vector<std::pair<std::string, std::string>>& change = {});

/// The same of a text.
Scene scene_of(const std::string& text, const std::string& name);

CommittedScene commit(const Scene& scene);

/// A lighting module by name, prepared for the scene. Throws Error(usage) where there is none of that name.
std::unique_ptr<LightingModule> prepared_lighting(const std::string& module, const World& world, std::uint32_t seed,
                                                  const Eye* eye = nullptr, const Params& options = {});

}  // namespace cardioid::test
