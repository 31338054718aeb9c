#pragma once
#include <vector>

#include "rt_core/render/committed_scene.hpp"

namespace cardioid {

/// White paper of a probe: it reflects all light that comes to its lit side evenly, so that pi times the radiance it
/// sends back is the irradiance. What comes from below the horizon of an opaque surface it lies on is kept out.
class PlateBsdf final : public Bsdf {
public:
    /// horizon: local; light from directions with dot(horizon, wi) < 0 counts as black. Zero: nothing is kept out.
    explicit PlateBsdf(Vec3 horizon) : horizon_(horizon) {}
    [[nodiscard]] Lobe lobes() const noexcept override { return Lobe::diffuse; }
    [[nodiscard]] Rgb f(Vec3 wo, Vec3 wi) const noexcept override {
        return wo.z * wi.z > 0 && dot(horizon_, wi) >= 0 ? Rgb(inv_pi) : Rgb{};
    }
    [[nodiscard]] float pdf(Vec3 wo, Vec3 wi, Lobe which) const noexcept override {
        return any(which & Lobe::diffuse) && wo.z * wi.z > 0 ? std::abs(wi.z) * inv_pi : 0;
    }
    [[nodiscard]] BsdfSample sample(Vec3 wo, float u_lobe, Vec2 u, Lobe which) const noexcept override;
    [[nodiscard]] Albedo albedo(Vec3) const noexcept override { return {.diffuse = Rgb(1)}; }

private:
    Vec3 horizon_;
};

/// The small plate whose irradiance is measured.
struct Plate {
    SurfacePoint point;   ///< frame is around the normal, or against it where the plate faces away from point.ng
    Vec3 normal;          ///< unit, world: the lit side
    Vec3 horizon;         ///< for PlateBsdf
    bool buried = false;  ///< inside an opaque solid, or its lit side lies flat on one: no light arrives
};

/// Finds where plates lie. Read-only once made, so any thread may call it; the scene must outlive it.
class PlateFinder {
public:
    explicit PlateFinder(const CommittedScene& scene);

    /// A face within about 1e-5 of p's coordinates that looks to the plate's lit side (60 degrees) takes the plate, or
    /// else one ten times nearer that looks elsewhere: the plate is moved onto it, rays that leave it pass over it,
    /// and the media are those of its two sides. Otherwise the plate is in free space. d must have unit length.
    [[nodiscard]] Plate place(Vec3d p, Vec3 d) const noexcept;

private:
    class Search;
    [[nodiscard]] bool is_opaque(const SurfacePoint& point) const noexcept;
    [[nodiscard]] bool is_solid(FaceId id, std::int32_t lamp) const noexcept;
    [[nodiscard]] bool is_buried(const Ray& ray, Vec3 n) const noexcept;
    Vec3 lay(Plate& plate) const noexcept;

    const CommittedScene& scene_;
    double scale_;                          ///< of the scene, scene units
    std::vector<const Region*> unbounded_;  ///< opaque ones
};

}  // namespace cardioid
