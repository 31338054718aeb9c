#pragma once
#include <cstddef>
#include <cstdint>
#include <new>
#include <type_traits>
#include <utility>

#include "rt_core/api/surface.hpp"

namespace cardioid {

/// Ways a surface sends light on; a set of them.
enum class Lobe : std::uint8_t {
    none = 0,
    diffuse = 1,
    glossy = 2,       ///< a lobe of finite width
    specular = 4,     ///< one direction: a delta
    transmitted = 8,  ///< together with one of the above: to the other side
    all = 15
};
constexpr Lobe operator|(Lobe a, Lobe b) { return static_cast<Lobe>(static_cast<int>(a) | static_cast<int>(b)); }
constexpr Lobe operator&(Lobe a, Lobe b) { return static_cast<Lobe>(static_cast<int>(a) & static_cast<int>(b)); }
constexpr bool any(Lobe a) { return a != Lobe::none; }

/// Share of the light from wo that goes each way, per channel, each in [0, 1], their sum at most 1.
/// Photon propagation draws its Russian roulette from it (ARL-TR-3608, equations 2-4).
struct Albedo {
    Rgb diffuse;
    Rgb specular;     ///< mirror and glossy reflection
    Rgb transmitted;  ///< to the other side, whether bent or not
    [[nodiscard]] Rgb total() const { return diffuse + specular + transmitted; }
};

/// A direction drawn by Bsdf::sample.
struct BsdfSample {
    Vec3 wi;        ///< local, unit
    Rgb weight;     ///< f |cos wi| / pdf, for a delta lobe its reflectance over its probability; black: nothing drawn
    float pdf = 0;  ///< per steradian over all non-delta lobes asked for; 0 for a delta lobe
    Lobe lobe = Lobe::none;  ///< the lobe it was drawn from
    [[nodiscard]] bool is_delta() const { return any(lobe & Lobe::specular); }
};

/// How a point scatters light. Directions are unit vectors in SurfacePoint::frame, both away from the surface:
/// z > 0 is the outer side of the solid. wo is where the light goes to (the eye), wi where it comes from.
/// Every function may be called from many threads.
class Bsdf {
public:
    virtual ~Bsdf() = default;
    /// Every lobe this point has.
    [[nodiscard]] virtual Lobe lobes() const noexcept = 0;
    /// BSDF value of the non-delta lobes [1/sr], without the cosine. Radiance is carried: transmission has the
    /// factor (eta_o / eta_i)^2, which photons (flux) must take off again.
    [[nodiscard]] virtual Rgb f(Vec3 wo, Vec3 wi) const noexcept = 0;
    /// Density [1/sr] with which sample(wo, ., ., which) draws wi from its non-delta lobes, on condition that it draws
    /// one of `which`.
    [[nodiscard]] virtual float pdf(Vec3 wo, Vec3 wi, Lobe which = Lobe::all) const noexcept = 0;
    /// Draws wi from the lobes in `which`; u_lobe chooses the lobe, u the direction, all in [0, 1).
    [[nodiscard]] virtual BsdfSample sample(Vec3 wo, float u_lobe, Vec2 u, Lobe which = Lobe::all) const noexcept = 0;
    [[nodiscard]] virtual Albedo albedo(Vec3 wo) const noexcept = 0;
    /// What direct light from a lamp at `distance` (scene units) is multiplied by, on top of the inverse square that is
    /// already in it. 1 is physics; the Phong model of ARL-TR-3608, note [9], has d^2/(a + b d + c d^2). Finite, >= 0.
    [[nodiscard]] virtual float attenuation(double /*distance*/) const noexcept { return 1; }
    /// How the diffuse lobe takes light from wi beside an even one. Where irradiance is known instead of directions the
    /// lobe is taken to be albedo(wo).diffuse / pi * diffuse_acceptance(wi), of mean 1 over |wi.z| dwi / pi. >= 0.
    [[nodiscard]] virtual float diffuse_acceptance(Vec3 /*wi*/) const noexcept { return 1; }
    [[nodiscard]] bool is_delta() const noexcept { return !any(lobes() & (Lobe::diffuse | Lobe::glossy)); }
};

/// Room for one Bsdf, so that shading never allocates. Bsdfs are trivially destructible.
class BsdfMemory {
public:
    static constexpr std::size_t size = 256;
    template <class T, class... Args>
    const T* make(Args&&... args) noexcept {
        static_assert(sizeof(T) <= size && alignof(T) <= 16);
        return new (bytes_) T(std::forward<Args>(args)...);
    }

private:
    alignas(16) std::byte bytes_[size];
};

}  // namespace cardioid
