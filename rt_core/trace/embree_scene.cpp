#include "rt_core/trace/embree_scene.hpp"

#include <cmath>
#include <cstring>
#include <limits>
#include <optional>

#include "rt_core/api/error.hpp"

namespace cardioid {
namespace {

constexpr unsigned solids_geometry = 0;

/// Two boundaries closer than this, relative to the distance and the scene, are one; the later solid shows.
constexpr double tie_tolerance = 1e-9;

/// Embree's rays are floats: a start on a triangle is lifted off it by this much of its largest coordinate,
/// four units in the last place.
constexpr double float_lift = 4 * 0x1p-23;

/// Embree takes no ray that starts farther out, and nothing is seen from there.
constexpr double farthest_origin = 1e18;

/// False too where a coordinate is not a number.
bool within_reach(const Ray& ray) {
    return dot(ray.o, ray.o) < farthest_origin * farthest_origin && dot(ray.d, ray.d) < 1e6;
}

float rounded_up(double t) { return static_cast<float>(t * (1 + 1e-6)); }

/// Float bounds that contain the box with room for the rounding of float rays.
void write_bounds(const Box3d& box, double scale, RTCBounds& out) {
    const Box3d b = box.padded(1e-6 * (scale + max_component(max(abs(box.lo), abs(box.hi)))));
    out.lower_x = static_cast<float>(b.lo.x), out.lower_y = static_cast<float>(b.lo.y);
    out.lower_z = static_cast<float>(b.lo.z), out.upper_x = static_cast<float>(b.hi.x);
    out.upper_y = static_cast<float>(b.hi.y), out.upper_z = static_cast<float>(b.hi.z);
}

bool count_bytes(void* counter, ssize_t bytes, bool) {
    static_cast<std::atomic<std::ptrdiff_t>*>(counter)->fetch_add(bytes, std::memory_order_relaxed);
    return true;
}

}  // namespace

/// What a query carries through Embree into the callback of the solids.
struct EmbreeScene::Query {
    embree::Context context;  // first, so that the context's address is the query's
    explicit Query(const Ray& r, double tie_) : ray(&r), tie(tie_) { embree::init(context); }
    [[nodiscard]] const Hit& best() const { return hits[best_at]; }
    /// Takes the other of the hits as the best, and lets the ray end there.
    void accept() {
        best_at = 1 - best_at;
        if (!shorter) ray = &shorter.emplace(*ray);
        shorter->t_max = std::min(shorter->t_max, best().t + tie);
    }
    // Neither the ray nor hits are copied while their parts are still being written, which would wait for them.
    const Ray* ray;  ///< the caller's, or `shorter` once a boundary is found
    double tie;
    std::optional<Ray> shorter;
    unsigned best_at = 0;
    Hit hits[2];
};

EmbreeScene::EmbreeScene(std::vector<Solid> solids, std::span<const TriangleSurface> surfaces,
                         std::uint32_t first_surface_id, double scale)
    : surfaces_(surfaces), first_surface_id_(first_surface_id), scale_(scale) {
    for (const Solid& solid : solids) (solid.region->bounds().bounded() ? bounded_ : unbounded_).push_back(solid);
    device_ = rtcNewDevice(nullptr);
    if (!device_) throw Error(ErrorCode::limit, "Embree cannot start on this processor");
    rtcSetDeviceMemoryMonitorFunction(device_, count_bytes, &bytes_);
    scene_ = rtcNewScene(device_);
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    if (!bounded_.empty()) add_solids();
    for (const TriangleSurface& surface : surfaces) add_surface(surface);
    rtcCommitScene(scene_);
    const RTCError error = rtcGetDeviceError(device_);
    if (error == RTC_ERROR_OUT_OF_MEMORY)
        throw Error(ErrorCode::limit, "out of memory while building Embree's hierarchy");
    if (error != RTC_ERROR_NONE) throw Error(ErrorCode::limit, "Embree cannot build its hierarchy of this scene");
}

EmbreeScene::~EmbreeScene() {
    if (scene_) rtcReleaseScene(scene_);
    if (device_) rtcReleaseDevice(device_);
}

void EmbreeScene::add_solids() {
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(bounded_.size()));
    rtcSetGeometryUserData(geometry, this);
    rtcSetGeometryBoundsFunction(
        geometry,
        [](const RTCBoundsFunctionArguments* a) {
            const auto& self = *static_cast<const EmbreeScene*>(a->geometryUserPtr);
            write_bounds(self.bounded_[a->primID].region->bounds(), self.scale_, *a->bounds_o);
        },
        nullptr);
    rtcSetGeometryIntersectFunction(geometry, [](const RTCIntersectFunctionNArguments* a) {
        if (!a->valid[0]) return;
        const auto& self = *static_cast<const EmbreeScene*>(a->geometryUserPtr);
        auto& query = *reinterpret_cast<Query*>(a->context);
        self.visit(self.bounded_[a->primID], query);
        auto& found = *reinterpret_cast<RTCRayHit*>(a->rayhit);
        if (query.best().id.region != self.bounded_[a->primID].id || rounded_up(query.best().t) >= found.ray.tfar)
            return;
        found.ray.tfar = rounded_up(query.best().t);
        found.hit.geomID = solids_geometry;
    });
    rtcSetGeometryOccludedFunction(geometry, [](const RTCOccludedFunctionNArguments* a) {
        if (!a->valid[0]) return;
        const auto& self = *static_cast<const EmbreeScene*>(a->geometryUserPtr);
        const Solid& solid = self.bounded_[a->primID];
        Hit hit;
        if (solid.region->first_boundary(*reinterpret_cast<const Query*>(a->context)->ray, solid.id, hit))
            reinterpret_cast<RTCRay*>(a->ray)->tfar = -std::numeric_limits<float>::infinity();
    });
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene_, geometry, solids_geometry);
    rtcReleaseGeometry(geometry);
}

void EmbreeScene::add_surface(const TriangleSurface& surface) {
    std::vector<float>& v = vertices_.emplace_back();
    v.reserve(surface.mesh->vertices.size() * 3 + 1);
    for (const Vec3d& local : surface.mesh->vertices) {
        const Vec3 p(surface.to_world.point(local));
        v.insert(v.end(), {p.x, p.y, p.z});
    }
    v.push_back(0);  // Embree reads 16 bytes from the last vertex
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, v.data(), 0, 12,
                               surface.mesh->vertices.size());
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, surface.mesh->triangles.data(), 0,
                               12, surface.mesh->triangles.size());
    corners_.push_back({v.data(), surface.mesh->triangles.data(), surface.to_world.determinant() < 0});
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene_, geometry, static_cast<unsigned>(vertices_.size()));
    rtcReleaseGeometry(geometry);
}

/// Asks one solid for a boundary nearer than the best; near ties go to the later solid, whatever the order of the
/// visits.
void EmbreeScene::visit(const Solid& solid, Query& query) const noexcept {
    Hit& hit = query.hits[1 - query.best_at];
    if (!solid.region->first_boundary(*query.ray, solid.id, hit)) return;
    const Hit& best = query.best();
    if (best.found()) {
        const bool tied = std::abs(hit.t - best.t) <= query.tie;
        if (tied ? solid.id < best.id.region : hit.t > best.t) return;
    }
    hit.id.region = solid.id;
    query.accept();
}

inline void EmbreeScene::embree_ray(const Ray& ray, RTCRay& r) const noexcept {
    Vec3d o = ray.o;
    if (ray.from.region >= first_surface_id_ && ray.from.region < first_surface_id_ + surfaces_.size()) {
        const double lift = float_lift * (max_component(abs(o)) + 1e-3 * scale_);
        o += Vec3d(ray.from_ng) * std::copysign(lift, dot(Vec3d(ray.from_ng), ray.d));
    }
    // Stored in fours, as Embree reads them: a load that spans several stores waits for all of them.
    using Four = float __attribute__((vector_size(16)));
    const Four origin{static_cast<float>(o.x), static_cast<float>(o.y), static_cast<float>(o.z), 0};
    const Four direction{static_cast<float>(ray.d.x), static_cast<float>(ray.d.y), static_cast<float>(ray.d.z), 0};
    std::memcpy(&r.org_x, &origin, sizeof origin);
    std::memcpy(&r.dir_x, &direction, sizeof direction);
    r.tfar = static_cast<float>(ray.t_max);
    r.mask = ~0U, r.id = 0, r.flags = 0;
}

namespace {

Hit triangle_hit(const RTCRayHit& found, std::uint32_t id, bool mirrored) {
    Hit hit;
    hit.t = static_cast<double>(found.ray.tfar);
    const Vec3 n = normalize(Vec3(found.hit.Ng_x, found.hit.Ng_y, found.hit.Ng_z));
    hit.ng = mirrored ? -n : n;
    hit.id = {id, found.hit.primID};
    hit.uv = {found.hit.u, found.hit.v};
    return hit;
}

}  // namespace

void EmbreeScene::refine(const Ray& ray, Hit& hit) const noexcept {
    const Corners& of = corners_[hit.id.region - first_surface_id_];
    const auto vertex = [&](std::size_t i) {
        const float* v = of.vertices + std::size_t{3} * of.triangles[hit.id.face][i];
        return Vec3d(v[0], v[1], v[2]);
    };
    const Vec3d a = vertex(0), n = cross(vertex(1) - a, vertex(2) - a);
    const double t = dot(a - ray.o, n) / dot(ray.d, n);
    // Seen edge-on the plane says nothing about the distance.
    if (!(t > 0 && std::abs(t - hit.t) < 1e-3 * t + 1e-6 * scale_)) return;
    hit.t = t;
    hit.ng = Vec3(normalize(of.mirrored ? -n : n));
}

Hit EmbreeScene::intersect(const Ray& ray) const noexcept {
    if (!within_reach(ray)) return {};
    Query query(ray, tie_tolerance * (scale_ + max_component(abs(ray.o))));
    for (const Solid& solid : unbounded_) visit(solid, query);
    RTCRayHit found;
    embree_ray(ray, found.ray);
    if (query.best().found()) found.ray.tfar = rounded_up(query.best().t);
    found.hit.geomID = found.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    embree::intersect(scene_, query.context, found);
    if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID || found.hit.geomID == solids_geometry) return query.best();
    if (query.best().found() && query.best().t <= static_cast<double>(found.ray.tfar)) return query.best();
    const std::uint32_t surface = found.hit.geomID - 1;
    return triangle_hit(found, first_surface_id_ + surface, corners_[surface].mirrored);
}

bool EmbreeScene::occluded(const Ray& ray) const noexcept {
    if (!within_reach(ray)) return false;
    Hit hit;
    for (const Solid& solid : unbounded_)
        if (solid.region->first_boundary(ray, solid.id, hit)) return true;
    Query query(ray, 0);
    RTCRay r;
    embree_ray(ray, r);
    embree::occluded(scene_, query.context, r);
    return r.tfar < 0;
}

std::size_t EmbreeScene::vertex_bytes() const noexcept {
    std::size_t bytes = 0;
    for (const auto& v : vertices_) bytes += v.capacity() * sizeof(float);
    return bytes;
}

}  // namespace cardioid
