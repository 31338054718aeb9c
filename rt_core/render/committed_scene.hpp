#pragma once
#include <functional>
#include <memory>
#include <vector>

#include "rt_core/api/registry.hpp"
#include "rt_core/api/world.hpp"
#include "rt_core/scene/scene.hpp"
#include "rt_core/trace/tracer.hpp"

namespace cardioid {

/// Turns solids into regions and surfaces; transparent[m] tells whether light enters material m. csg::compile is it.
using CompileSolids = std::function<Geometry(const Scene&, const std::vector<bool>& transparent)>;

struct CommitOptions {
    bool studio = true;   ///< a scene without light gets the studio: sky, key light
    bool ground = false;  ///< and a ground plane under it
};

/// A scene with its materials, lights and tracer made: all that rendering asks.
class CommittedScene final : public World {
public:
    /// Makes every material and light by the registry. Throws Error(bad_input, io, limit).
    CommittedScene(const Scene& scene, const Registry& registry, const CompileSolids& compile,
                   const CommitOptions& options = {});
    ~CommittedScene() override;

    [[nodiscard]] Hit intersect(const Ray& ray) const noexcept override;
    [[nodiscard]] bool occluded(const Ray& ray) const noexcept override;
    [[nodiscard]] Rgb transmittance(const Ray& ray) const noexcept override;
    [[nodiscard]] SurfacePoint surface(const Ray& ray, const Hit& hit) const noexcept override;
    [[nodiscard]] const Medium* medium_at(Vec3d p) const noexcept override;
    [[nodiscard]] std::span<const Material> materials() const noexcept override { return materials_; }
    [[nodiscard]] std::span<const std::unique_ptr<Light>> lights() const noexcept override { return lights_; }
    [[nodiscard]] Box3d bounds() const noexcept override { return tracer_->bounds(); }
    [[nodiscard]] std::size_t face_count() const noexcept override;
    [[nodiscard]] std::uint64_t hash() const noexcept override { return hash_; }
    [[nodiscard]] Rgb emitted(const SurfacePoint& point, Vec3 wo) const noexcept override;
    [[nodiscard]] Rgb escaped(Vec3 d) const noexcept override;
    [[nodiscard]] Rgb direct(const SurfacePoint& point, const Bsdf& bsdf, Vec3 wo,
                             Sampler& sampler) const noexcept override;

    /// What a camera ray that leaves the scene sees.
    [[nodiscard]] Rgb backdrop(Vec3 d) const noexcept;
    [[nodiscard]] const Tracer& tracer() const noexcept { return *tracer_; }
    /// Warnings about the scene: no light, nothing to see ...
    [[nodiscard]] const std::vector<std::string>& warnings() const noexcept { return warnings_; }

private:
    std::vector<Material> materials_;
    std::vector<std::unique_ptr<Light>> lights_;
    std::vector<std::int32_t> lamp_light_;  ///< light of each lamp of the tracer
    std::unique_ptr<Tracer> tracer_;
    std::vector<std::string> warnings_;
    std::uint64_t hash_ = 0;
};

}  // namespace cardioid
