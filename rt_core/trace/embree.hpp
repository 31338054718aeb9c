#pragma once
/// Levels Embree 3 (Debian 12) and Embree 4 (Debian 13): the only file that includes either.
#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace cardioid::embree {

#if RTC_VERSION_MAJOR >= 4
using Context = RTCRayQueryContext;

inline void intersect(RTCScene scene, Context& context, RTCRayHit& ray_hit) {
    RTCIntersectArguments arguments;
    rtcInitIntersectArguments(&arguments);
    arguments.context = &context;
    rtcIntersect1(scene, &ray_hit, &arguments);
}
inline void occluded(RTCScene scene, Context& context, RTCRay& ray) {
    RTCOccludedArguments arguments;
    rtcInitOccludedArguments(&arguments);
    arguments.context = &context;
    rtcOccluded1(scene, &ray, &arguments);
}
inline void init(Context& context) { rtcInitRayQueryContext(&context); }
#else
using Context = RTCIntersectContext;

inline void intersect(RTCScene scene, Context& context, RTCRayHit& ray_hit) {
    rtcIntersect1(scene, &context, &ray_hit);
}
inline void occluded(RTCScene scene, Context& context, RTCRay& ray) { rtcOccluded1(scene, &context, &ray); }
inline void init(Context& context) { rtcInitIntersectContext(&context); }
#endif

}  // namespace cardioid::embree
