#pragma once
#include <memory>
#include <span>
#include <vector>

#include "rt_core/api/light.hpp"
#include "rt_core/trace/geometry.hpp"

namespace cardioid {

class EmbreeScene;

/// Bytes the tracer holds, for `--stats`.
struct TracerMemory {
    std::size_t regions = 0;    ///< solids with their leaves, trees and inner hierarchies
    std::size_t leaves = 0;     ///< how many leaves that is
    std::size_t embree = 0;     ///< Embree's own
    std::size_t triangles = 0;  ///< vertex and index buffers shared with Embree
    std::size_t triangle_count = 0;
};

/// Finds the nearest boundary of everything in the scene by one Embree query: triangles by Embree itself, solids and
/// lamps in double precision by a callback. Every const function may be called from any thread.
class Tracer {
public:
    /// Takes the geometry over. Throws Error(limit) where memory runs out.
    Tracer(Geometry geometry, const std::vector<LampShape>& lamps);
    ~Tracer();
    Tracer(const Tracer&) = delete;
    Tracer& operator=(const Tracer&) = delete;

    [[nodiscard]] Hit intersect(const Ray& ray) const noexcept;
    [[nodiscard]] bool occluded(const Ray& ray) const noexcept;
    /// Distance and normal of a hit in double precision: those of solids are already, triangles are met in single.
    void refine(const Ray& ray, Hit& hit) const noexcept;

    [[nodiscard]] std::span<const std::unique_ptr<Region>> regions() const noexcept { return geometry_.regions; }
    [[nodiscard]] std::span<const TriangleSurface> surfaces() const noexcept { return geometry_.surfaces; }
    [[nodiscard]] bool is_region(std::uint32_t id) const noexcept { return id < geometry_.regions.size(); }
    /// Index of the lamp that `id` names, or -1.
    [[nodiscard]] std::int32_t lamp(std::uint32_t id) const noexcept;
    [[nodiscard]] FaceId lamp_face(std::size_t lamp) const noexcept;
    /// Material of a hit that is not on a lamp.
    [[nodiscard]] std::uint32_t material(const Hit& hit) const noexcept;
    /// Around everything bounded, lamps included.
    [[nodiscard]] Box3d bounds() const noexcept { return bounds_; }
    [[nodiscard]] TracerMemory memory() const noexcept;

private:
    [[nodiscard]] std::size_t first_lamp() const noexcept;

    Geometry geometry_;
    std::vector<std::unique_ptr<Region>> lamps_;
    Box3d bounds_;
    std::unique_ptr<EmbreeScene> embree_;
};

}  // namespace cardioid
