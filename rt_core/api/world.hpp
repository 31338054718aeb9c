#pragma once
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "rt_core/api/light.hpp"
#include "rt_core/api/shader.hpp"

namespace cardioid {

/// A material of the committed scene.
struct Material {
    std::string name;
    std::shared_ptr<const Shader> shader;
    Rgb emission;  ///< radiance that leaves the outer side, besides what the shader scatters
};

/// The committed scene as hooks may ask it. Every const function may be called from any thread.
class World {
public:
    virtual ~World() = default;

    /// Nearest boundary along the ray in (0, t_max), or a Hit that is not found().
    [[nodiscard]] virtual Hit intersect(const Ray& ray) const noexcept = 0;
    /// Whether anything stands in (0, t_max).
    [[nodiscard]] virtual bool occluded(const Ray& ray) const noexcept = 0;
    /// Share of light that gets from ray.o to t_max: 0 behind anything opaque, less what materials with straight
    /// shadows take. The medium at ray.o is taken to fill the whole way, and what it absorbs is left to the caller;
    /// what other media on the way absorb more, or less, is in the share.
    [[nodiscard]] virtual Rgb transmittance(const Ray& ray) const noexcept = 0;
    /// All about the point that `hit` found on `ray`, media on both sides included.
    [[nodiscard]] virtual SurfacePoint surface(const Ray& ray, const Hit& hit) const noexcept = 0;
    /// What fills the place p; never null.
    [[nodiscard]] virtual const Medium* medium_at(Vec3d p) const noexcept = 0;

    [[nodiscard]] virtual std::span<const Material> materials() const noexcept = 0;
    [[nodiscard]] virtual std::span<const std::unique_ptr<Light>> lights() const noexcept = 0;
    /// Box around all bounded geometry.
    [[nodiscard]] virtual Box3d bounds() const noexcept = 0;
    /// Triangles, or faces of solids, for rules that count them (ARL-TR-3608 [1]).
    [[nodiscard]] virtual std::size_t face_count() const noexcept = 0;
    /// Changes whenever geometry, materials or lights do; stored in map files.
    [[nodiscard]] virtual std::uint64_t hash() const noexcept = 0;

    /// Radiance that `point` emits towards wo (world): its material's or its lamp's.
    [[nodiscard]] virtual Rgb emitted(const SurfacePoint& point, Vec3 wo) const noexcept = 0;
    /// Radiance of all lights at infinity along d.
    [[nodiscard]] virtual Rgb escaped(Vec3 d) const noexcept = 0;
    /// Light that reaches `point` straight from the lights and leaves along wo (world) by the non-delta lobes (report
    /// [9]).
    [[nodiscard]] virtual Rgb direct(const SurfacePoint& point, const Bsdf& bsdf, Vec3 wo,
                                     Sampler& sampler) const noexcept = 0;

    /// Index into lights() of the light that a face belongs to, its lamp's or its emissive solid's; -1 where it belongs
    /// to none.
    [[nodiscard]] virtual std::int32_t light_of(FaceId face) const noexcept = 0;

    /// The Bsdf at a point; shorthand for materials()[point.material].shader->bsdf.
    [[nodiscard]] const Bsdf* bsdf(const SurfacePoint& point, BsdfMemory& memory) const noexcept {
        return materials()[point.material].shader->bsdf(point, memory);
    }
};

}  // namespace cardioid
