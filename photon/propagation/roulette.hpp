#pragma once
#include "photon/options/choices.hpp"
#include "rt_core/api/world.hpp"

namespace cardioid::photon {

/// How Russian roulette is played.
struct RouletteRule {
    Roulette by = Roulette::flux;
    bool double_count = false;  ///< the report's slip: survivors are scaled by the reflectance once more
};

/// Where a photon goes from a surface, and with what.
struct Scattered {
    Vec3 wi;   ///< local, unit: the new direction
    Rgb flux;  ///< W; black: it ended here
    Lobe lobe = Lobe::none;
    bool straight = false;  ///< passed a thin filter, which neither bends nor counts as specular
};

/// Scatters a photon of `flux` that came from wo (local) by the lobes in `which`. One of diffuse and the other lobes is
/// chosen in proportion to what each would reflect, P_x = max_c(rho_x,c Phi_c) / max_c Phi_c, the Bsdf draws a
/// direction of weight w, and the photon goes on with the chance that keeps its largest channel as it is, where that
/// is not above 1: Phi' = Phi w / P (ARL-TR-3608, equations 2 to 4, with the rule of Jensen 2001, section 5.2.3). Where
/// w is flat the chance to go on by x is P_x exactly.
/// Weights are turned from radiance into flux: refraction keeps flux, and where the shading normal is not the
/// geometric one Veach's factor is applied (Veach 1997, section 5.3). u: choice and roulette; u_direction: all in [0,
/// 1).
struct ScatterQuery {
    const World& world;
    const SurfacePoint& point;
    const Bsdf& bsdf;
    Vec3 wo;  ///< local
    Rgb flux;
    Lobe which = Lobe::all;
    RouletteRule rule{};
};
[[nodiscard]] Scattered scatter(const ScatterQuery& query, Vec2 u, Vec2 u_direction) noexcept;

/// Whether a sample towards wo (local) went through a thin film, which World::direct looks through as well.
[[nodiscard]] bool passes_filter(const World& world, const SurfacePoint& point, Vec3 wo, const BsdfSample& s) noexcept;

/// Flux after a length of an absorbing medium; the roulette keeps its largest channel. u in [0, 1).
[[nodiscard]] Rgb pass_medium(const Medium& medium, double length, Rgb flux, float u) noexcept;

}  // namespace cardioid::photon
