#pragma once
#include <atomic>
#include <memory>
#include <span>
#include <vector>

#include "rt_core/trace/embree.hpp"
#include "rt_core/trace/geometry.hpp"

namespace cardioid {

/// One Embree scene over solids (user geometry 0) and surfaces (triangle geometry s + 1).
/// Hit ids: solids have the ids they are given, surface s has first_surface_id + s.
class EmbreeScene {
public:
    struct Solid {
        const Region* region;
        std::uint32_t id;
    };
    /// Throws Error(limit) where Embree runs out of memory. `scale` is the size of the scene.
    EmbreeScene(std::vector<Solid> solids, std::span<const TriangleSurface> surfaces, std::uint32_t first_surface_id,
                double scale);
    ~EmbreeScene();
    EmbreeScene(const EmbreeScene&) = delete;
    EmbreeScene& operator=(const EmbreeScene&) = delete;

    [[nodiscard]] Hit intersect(const Ray& ray) const noexcept;
    [[nodiscard]] bool occluded(const Ray& ray) const noexcept;
    /// Embree's own bytes, and those of the vertices it shares with us.
    [[nodiscard]] std::size_t embree_bytes() const noexcept { return static_cast<std::size_t>(bytes_.load()); }
    [[nodiscard]] std::size_t vertex_bytes() const noexcept;

private:
    struct Query;
    void add_solids();
    void add_surface(const TriangleSurface& surface);
    void visit(const Solid& solid, Query& query) const noexcept;
    [[nodiscard]] Hit triangle_hit(const RTCRayHit& found, const Ray& ray) const noexcept;
    [[nodiscard]] RTCRay embree_ray(const Ray& ray) const noexcept;
    [[nodiscard]] Vec3d vertex(std::uint32_t surface, std::uint32_t index) const noexcept;

    std::vector<Solid> bounded_;    ///< by Embree's primitive number
    std::vector<Solid> unbounded_;  ///< solids with an infinite box, tried before Embree
    std::span<const TriangleSurface> surfaces_;
    std::uint32_t first_surface_id_;
    double scale_;
    std::vector<std::vector<float>> vertices_;  ///< per surface, three floats each and one to pad
    std::atomic<std::ptrdiff_t> bytes_{0};
    RTCDevice device_ = nullptr;
    RTCScene scene_ = nullptr;
};

}  // namespace cardioid
