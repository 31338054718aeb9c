#pragma once
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "rt_core/api/bsdf.hpp"
#include "rt_core/api/params.hpp"

namespace cardioid {

/// A material: parameters of the scene file turned into a Bsdf at each hit. Read-only after its making, so any thread
/// may call it.
class Shader {
public:
    virtual ~Shader() = default;
    /// How the surface scatters at `hit`; lives in `memory`. Never null.
    [[nodiscard]] virtual const Bsdf* bsdf(const SurfacePoint& hit, BsdfMemory& memory) const noexcept = 0;
    /// Radiance that leaves the outer side towards wo (local) besides what the host adds for `emission`.
    [[nodiscard]] virtual Rgb emission(const SurfacePoint& /*hit*/, Vec3 /*wo*/) const noexcept { return {}; }
    /// What fills a solid of this material, or null for a material that no light enters.
    [[nodiscard]] virtual const Medium* interior() const noexcept { return nullptr; }
    /// Share of light that passes straight through one crossing of the surface (thin colour filters), for shadow rays.
    [[nodiscard]] virtual Rgb straight_transmittance(const SurfacePoint& /*hit*/, Vec3 /*wo*/) const noexcept {
        return {};
    }
    /// Whether straight_transmittance() is anywhere more than black; where no material filters, a shadow ray ends at
    /// the first thing it meets. Whoever overrides the one overrides the other.
    [[nodiscard]] virtual bool filters() const noexcept { return false; }
};

/// What a shader's maker gets.
struct ShaderInputs {
    const Params& params;
    /// Another material of the scene by name (checker fields); throws Error(bad_input) where there is none.
    std::function<std::shared_ptr<const Shader>(std::string_view)> find_material;
};

/// A kind of material in the registry: define_material(name, kind = "<name>", ...).
struct ShaderKind {
    const char* name;
    const char* help;                                            ///< one sentence
    std::span<const ParamSpec> params;                           ///< `emission` is the host's and need not be listed
    std::shared_ptr<const Shader> (*make)(const ShaderInputs&);  ///< throws Error(bad_input)
};

}  // namespace cardioid
