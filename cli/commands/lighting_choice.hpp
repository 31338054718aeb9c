#pragma once
#include <memory>
#include <string>

#include "cli/options/run_options.hpp"
#include "rt_core/api/registry.hpp"
#include "rt_core/scene/scene.hpp"

namespace cardioid::cli {

/// The lighting module that the options ask for.
struct LightingChoice {
    const LightingKind* kind = nullptr;
    Params params;                      ///< the scene's photons(...) and --set
    std::vector<std::string> warnings;  ///< --set that has no effect
};

/// Throws Error(usage) with the nearest right name where there is no such module or option.
LightingChoice choose_lighting(const RunOptions& options, const Scene& scene, const Registry& registry);

/// Takes `straight_shadows` from glass where the module follows bent light to what it falls on, or that light would
/// count twice; says so in choice.warnings.
void end_straight_shadows(Scene& scene, LightingChoice& choice);

/// Makes the module; what it says against a value of --set is Error(usage).
std::unique_ptr<LightingModule> make_lighting(const LightingChoice& choice, std::uint32_t seed);

}  // namespace cardioid::cli
