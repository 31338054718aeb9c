#pragma once
#include <cstdint>
#include <limits>

#include "rt_core/api/math.hpp"

namespace cardioid {

/// What fills a transparent solid.
struct Medium {
    float ior = 1;   ///< index of refraction
    Rgb absorption;  ///< per scene unit; transmittance over a length d is exp(-absorption d) (Beer-Lambert)
    int priority =
        0;  ///< where solids overlap the higher one fills the place; at equal priority the earlier in the file

    constexpr bool operator==(const Medium&) const = default;
};

/// Names a face of the scene: what a ray leaves from, so that it does not meet it again at distance 0.
struct FaceId {
    static constexpr std::uint32_t none = 0xFFFFFFFFU;
    std::uint32_t region = none;  ///< solid, triangle mesh or lamp
    std::uint32_t face = none;    ///< leaf and its face within a solid, or triangle
    constexpr bool operator==(const FaceId&) const = default;
};

/// o + t d for t in (0, t_max). d has unit length to float precision.
struct Ray {
    Vec3d o;
    Vec3d d;
    double t_max = std::numeric_limits<double>::infinity();
    FaceId from;   ///< the face that o lies on, `none` where o is in free space
    Vec3 from_ng;  ///< normal of that face; coincident parallel faces at o are passed over with it
};

/// The nearest boundary along a ray, as little as is needed to go on; World::surface tells the rest.
struct Hit {
    double t = std::numeric_limits<double>::infinity();  ///< of a triangle in single precision only
    FaceId id;
    Vec3 ng;                 ///< outward geometric normal of the solid, unit length
    std::uint32_t leaf = 0;  ///< of the region: who owns the face, tells the material
    Vec2 uv;                 ///< barycentric coordinates on triangles
    [[nodiscard]] bool found() const { return id.region != FaceId::none; }
};

/// A point of a surface as shaders and lighting modules see it.
struct SurfacePoint {
    Vec3d p;      ///< scene units
    Vec3 ng;      ///< geometric normal, unit, out of the solid
    Frame frame;  ///< around the shading normal n = frame.n, on ng's side
    FaceId id;
    std::uint32_t material = 0;     ///< index into World::materials
    std::int32_t lamp = -1;         ///< index into World::lights where this is a lamp's own plate or ball
    const Medium* front = nullptr;  ///< what the point's outer side (+ng) is filled with; never null once resolved
    const Medium* back = nullptr;   ///< and its inner side
    double footprint = 0;           ///< width of a pixel here, scene units; 0 where unknown

    /// A ray that leaves this point along the unit world direction d.
    [[nodiscard]] Ray ray(Vec3 d, double t_max = std::numeric_limits<double>::infinity()) const {
        return {p, Vec3d(d), t_max, id, ng};
    }
};

}  // namespace cardioid
