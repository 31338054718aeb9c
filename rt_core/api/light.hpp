#pragma once
#include <memory>
#include <optional>

#include "rt_core/api/params.hpp"
#include "rt_core/api/surface.hpp"

namespace cardioid {

/// Light that arrives at a point from one drawn direction. Its share of reflected radiance is f L |cos| / pdf.
struct LightSample {
    Vec3 wi;              ///< unit, towards the light, world
    double distance = 0;  ///< scene units; infinite for sky and sun
    Rgb L;          ///< radiance [W/(sr unit^2)]; for a delta light intensity/distance^2 or irradiance; black: nothing
    float pdf = 1;  ///< per steradian; 1 for a delta light
    bool delta = false;  ///< no ray finds this light by chance
    bool trace = false;  ///< L is not known yet: it is what a ray along wi finds on this light (emissive solids)
};

/// A ray with flux, for photons.
struct LightEmission {
    Ray ray;   ///< `from` names the emitting face, so that the lamp does not trap its own photons (ARL-TR-3608 [3])
    Rgb flux;  ///< W, for one ray drawn of one: E[flux] = power
};

/// The plate or ball of a lamp; it emits in front, absorbs what hits it and casts shadows.
struct LampShape {
    enum class Kind { rectangle, disc, sphere } kind;
    Affine to_world;  ///< local origin is the centre; a plate lies in the local xy plane, its front is local -z
    Vec2d size;       ///< full width and height; radius in x for disc and sphere
};

/// A source of light. Read-only after its making, so any thread may call it.
class Light {
public:
    virtual ~Light() = default;
    /// A direction towards the light from p, u in [0,1)^2.
    [[nodiscard]] virtual LightSample sample(Vec3d p, Vec2 u) const noexcept = 0;
    /// Density [1/sr] with which sample() draws wi from p; 0 for delta lights and directions that miss.
    [[nodiscard]] virtual float pdf(Vec3d p, Vec3 wi) const noexcept = 0;
    /// A photon's ray; u_place, u_direction in [0,1)^2.
    [[nodiscard]] virtual LightEmission emit(Vec2 u_place, Vec2 u_direction) const noexcept = 0;
    /// Total flux [W]; of sky and sun: what enters the bounding sphere given to prepare().
    [[nodiscard]] virtual Rgb power() const noexcept = 0;
    /// Radiance that leaves its own geometry at p (outward normal ng) along the unit world direction wo.
    [[nodiscard]] virtual Rgb emitted(Vec3d /*p*/, Vec3 /*ng*/, Vec3 /*wo*/) const noexcept { return {}; }
    /// Radiance from infinity along the unit direction d (as the eye looks), for rays that leave the scene.
    [[nodiscard]] virtual Rgb escaped(Vec3 /*d*/) const noexcept { return {}; }
    /// What a camera ray that leaves the scene sees; a backdrop may differ from the light it gives.
    [[nodiscard]] virtual Rgb backdrop(Vec3 d) const noexcept { return escaped(d); }
    /// What rays meet of it; nothing for points, spots, sun and sky, and for invisible lamps.
    [[nodiscard]] virtual std::optional<LampShape> shape() const noexcept { return std::nullopt; }
    /// Whether a shadow ray is needed at all.
    [[nodiscard]] virtual bool casts_shadows() const noexcept { return true; }
    /// Called once before rendering with a sphere around the whole scene.
    virtual void prepare(Vec3d /*centre*/, double /*radius*/) {}
    /// Called once for a lamp with shape(): the id that rays will report for it, for LightEmission::ray.from.
    virtual void set_face(FaceId) {}
    /// K where this light stands for K x K points of equal power (0: for all its surface): sample() then gives the
    /// point of the stratum that u lies in.
    [[nodiscard]] virtual int grid() const noexcept { return 0; }
};

/// What a light's maker gets.
struct LightInputs {
    const Params& params;
    Affine to_world;       ///< of the place it stands in the file
    std::string base_dir;  ///< relative files are looked for here
};

/// A kind of light in the registry: a call of this name in the scene file.
struct LightKind {
    const char* name;
    const char* help;
    std::span<const ParamSpec> params;                   ///< in the order that positional arguments fill
    std::unique_ptr<Light> (*make)(const LightInputs&);  ///< throws Error(bad_input, io)
};

}  // namespace cardioid
