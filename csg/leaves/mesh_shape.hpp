#pragma once
#include <memory>

#include "csg/bvh/bvh8.hpp"
#include "csg/leaves/leaf.hpp"

namespace cardioid::csg {

/// A closed triangle mesh that every line crosses an even number of times, also through edges and vertices:
/// triangles are projected along the line with the same numbers for every triangle at a vertex (Woop et al. 2013),
/// and the crossing of an edge is decided by a half-open rule with an exact sign.
class MeshShape {
public:
    explicit MeshShape(std::shared_ptr<const TriangleMesh> mesh);
    /// Appends the crossings of the line o + t d as events of leaf `index`, sorted.
    void append_events(std::uint32_t index, Vec3d o, Vec3d d, EventList& out) const;
    /// Of triangle `face`, not normalised, out of the mesh.
    [[nodiscard]] Vec3d normal(std::uint32_t face) const;
    [[nodiscard]] std::size_t memory_bytes() const noexcept;

private:
    std::shared_ptr<const TriangleMesh> mesh_;
    Bvh8 bvh_;
};

}  // namespace cardioid::csg
