#include "rt_core/trace/geometry.hpp"

namespace cardioid {

Box3d bounded_box(const Geometry& geometry) {
    Box3d box;
    for (const auto& region : geometry.regions)
        if (const Box3d b = region->bounds(); b.bounded()) box.include(b);
    for (const TriangleSurface& surface : geometry.surfaces)
        for (const Vec3d& v : surface.mesh->vertices) box.include(surface.to_world.point(v));
    return box;
}

}  // namespace cardioid
