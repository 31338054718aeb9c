#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "rt_core/api/eye.hpp"
#include "rt_core/api/progress.hpp"
#include "rt_core/api/world.hpp"

namespace cardioid {

/// Radiance by the way it came, each a picture layer; they sum to the beauty picture (ARL-TR-3608, equation 1).
struct LightParts {
    Rgb emission;  ///< light seen at its source
    Rgb direct;    ///< L D E
    Rgb specular;  ///< seen in a mirror or through glass: ... S+ E
    Rgb caustic;   ///< L S+ D E
    Rgb indirect;  ///< L (S|D)* D D E
    [[nodiscard]] Rgb sum() const { return emission + direct + specular + caustic + indirect; }
};

/// A named figure for `--stats` and -v.
using Statistic = std::pair<std::string, std::variant<double, std::int64_t, std::string>>;

/// How light travels between surfaces. `direct` has none of it, `photon` reads its maps, `path` traces on.
/// Life: make -> prepare (or load) once -> lookups from many threads -> statistics, save.
class LightingModule {
public:
    virtual ~LightingModule() = default;

    /// The passes before rendering: emission, maps, cache. `eye` is what will be drawn, null where single points will
    /// be asked for (probe). Throws Error. Reports progress and returns early when interrupted.
    virtual void prepare(const World& /*world*/, const Eye* /*eye*/, Progress& /*progress*/) {}

    /// Radiance that leaves `point` along wo (world) by its non-delta lobes, of light that met a diffuse surface
    /// before.
    [[nodiscard]] virtual Rgb indirect(const World& /*world*/, const SurfacePoint& /*point*/, const Bsdf& /*bsdf*/,
                                       Vec3 /*wo*/, Sampler& /*sampler*/) const noexcept {
        return {};
    }
    /// The same of light that came from its source by mirrors and glass alone.
    [[nodiscard]] virtual Rgb caustic(const World& /*world*/, const SurfacePoint& /*point*/, const Bsdf& /*bsdf*/,
                                      Vec3 /*wo*/, Sampler& /*sampler*/) const noexcept {
        return {};
    }
    /// What shadow photons know: 1 lit by that light, 0 in its shadow, nothing where a shadow ray must tell.
    [[nodiscard]] virtual std::optional<float> shadow(const SurfacePoint& /*point*/,
                                                      std::size_t /*light*/) const noexcept {
        return std::nullopt;
    }
    /// A module that follows the whole path itself returns all light that comes along the ray; the host then asks
    /// nothing else of it for pictures, but indirect() and caustic() still for single points.
    [[nodiscard]] virtual std::optional<LightParts> incoming(const World& /*world*/, const EyeRay& /*eye*/,
                                                             Sampler& /*sampler*/) const noexcept {
        return std::nullopt;
    }

    /// Names of pictures for `--view`, and one pixel of such a picture.
    [[nodiscard]] virtual std::vector<std::string> views() const { return {}; }
    [[nodiscard]] virtual Rgb view(const std::string& /*name*/, const World& /*world*/,
                                   const SurfacePoint& /*point*/) const noexcept {
        return {};
    }

    [[nodiscard]] virtual std::vector<Statistic> statistics() const { return {}; }
    /// Whole maps to and from a file; load() stands in for prepare() and refuses a map of another World::hash(). Both
    /// throw Error.
    virtual void save(const std::string& path) const;
    virtual void load(const std::string& path, const World& world, const Eye* eye, Progress& progress);
};

inline void LightingModule::save(const std::string& path) const {
    throw Error(ErrorCode::usage, path + ": this lighting has no map to save");
}
inline void LightingModule::load(const std::string& path, const World&, const Eye*, Progress&) {
    throw Error(ErrorCode::usage, path + ": this lighting has no map to load");
}

/// A lighting module in the registry: `--lighting <name>`, options by `--set <name>.<param>=value`.
struct LightingKind {
    const char* name;
    const char* help;
    std::span<const ParamSpec> params;
    std::unique_ptr<LightingModule> (*make)(const Params&, std::uint32_t seed);
};

}  // namespace cardioid
