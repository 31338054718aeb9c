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
    /// Distance and normal of a hit on a surface in double precision; Embree gives them in single.
    void refine(const Ray& ray, Hit& hit) const noexcept;
    /// Embree's own bytes, and those of the vertices it shares with us.
    [[nodiscard]] std::size_t embree_bytes() const noexcept { return static_cast<std::size_t>(bytes_.load()); }
    [[nodiscard]] std::size_t vertex_bytes() const noexcept;

private:
    struct Query;
    /// What a hit on a surface needs, side by side.
    struct Corners {
        const float* vertices;
        const std::array<std::uint32_t, 3>* triangles;
        bool mirrored;
    };
    void add_solids();
    void add_surface(const TriangleSurface& surface);
    void visit(const Solid& solid, Query& query) const noexcept;
    void embree_ray(const Ray& ray, RTCRay& r) const noexcept;

    std::vector<Solid> bounded_;    ///< by Embree's primitive number
    std::vector<Solid> unbounded_;  ///< solids with an infinite box, tried before Embree
    std::span<const TriangleSurface> surfaces_;
    std::uint32_t first_surface_id_;
    double scale_;
    std::vector<Corners> corners_;              ///< per surface
    std::vector<std::vector<float>> vertices_;  ///< per surface, three floats each and one to pad
    std::atomic<std::ptrdiff_t> bytes_{0};
    RTCDevice device_ = nullptr;
    RTCScene scene_ = nullptr;
};

}  // namespace cardioid
