#include "bench/raw_embree.hpp"

#include <cmath>
#include <limits>

namespace cardioid::bench {

RawEmbree::RawEmbree(const TriangleMesh& mesh, Flags flags) : device_(rtcNewDevice(nullptr)) {
    rtcSetDeviceMemoryMonitorFunction(
        device_,
        [](void* counter, ssize_t bytes, bool) {
            *static_cast<std::ptrdiff_t*>(counter) += bytes;
            return true;
        },
        &bytes_);
    scene_ = rtcNewScene(device_);
    if (flags == Flags::robust) rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* v = static_cast<float*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, mesh.vertices.size()));
    for (const Vec3d& p : mesh.vertices)
        for (int axis = 0; axis < 3; ++axis) *v++ = static_cast<float>(p[axis]);
    auto* t = static_cast<std::uint32_t*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, mesh.triangles.size()));
    for (const auto& triangle : mesh.triangles)
        for (const std::uint32_t corner : triangle) *t++ = corner;
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
}

RawEmbree::~RawEmbree() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
}

std::size_t RawEmbree::trace(const std::vector<RTCRay>& rays) const {
    embree::Context context;
    embree::init(context);
    std::size_t hits = 0;
    for (const RTCRay& ray : rays) {
        RTCRayHit found;
        found.ray = ray;
        found.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        found.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
        embree::intersect(scene_, context, found);
        hits += found.hit.geomID != RTC_INVALID_GEOMETRY_ID;
    }
    return hits;
}

std::size_t RawEmbree::trace_occlusion(const std::vector<RTCRay>& rays) const {
    embree::Context context;
    embree::init(context);
    std::size_t hits = 0;
    for (RTCRay ray : rays) {
        embree::occluded(scene_, context, ray);
        hits += ray.tfar < 0;
    }
    return hits;
}

std::vector<RTCRay> raw_rays(const Rays& rays, double lift) {
    std::vector<RTCRay> out;
    for (const Ray& ray : rays) {
        Vec3d o = ray.o;
        if (ray.from.region != FaceId::none)
            o += Vec3d(ray.from_ng) * std::copysign(lift * max_component(abs(o)), dot(Vec3d(ray.from_ng), ray.d));
        RTCRay r{};
        r.org_x = static_cast<float>(o.x), r.org_y = static_cast<float>(o.y), r.org_z = static_cast<float>(o.z);
        r.dir_x = static_cast<float>(ray.d.x), r.dir_y = static_cast<float>(ray.d.y);
        r.dir_z = static_cast<float>(ray.d.z);
        r.tfar = std::numeric_limits<float>::infinity();
        r.mask = ~0U;
        out.push_back(r);
    }
    return out;
}

}  // namespace cardioid::bench
