#include <algorithm>
#include <cmath>

#include "csg/bvh/bvh8.hpp"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace cardioid::csg {

unsigned hit_boxes_plain(const BvhNode& node, const BoxRay& ray, float t_min, float t_max, float* entry) noexcept {
    unsigned mask = 0;
    for (unsigned i = 0; i < 8; ++i) {
        float enter = t_min, leave = t_max;
        for (int axis = 0; axis < 3; ++axis) {
            const bool down = ray.inverse_d[axis] < 0;
            const float near = ((down ? node.hi : node.lo)[axis][i] - ray.o[axis]) * ray.inverse_d[axis];
            const float far = ((down ? node.lo : node.hi)[axis][i] - ray.o[axis]) * ray.inverse_d[axis];
            enter = enter > near ? enter : near;
            leave = leave < far ? leave : far;
        }
        entry[i] = enter;
        mask |= static_cast<unsigned>(enter <= leave) << i;
    }
    return mask;
}

#if defined(__x86_64__)
namespace {

__attribute__((target("avx2"))) unsigned hit_boxes_avx2(const BvhNode& node, const BoxRay& ray, float t_min,
                                                        float t_max, float* entry) noexcept {
    __m256 enter = _mm256_set1_ps(t_min), leave = _mm256_set1_ps(t_max);
    for (int axis = 0; axis < 3; ++axis) {
        const bool down = ray.inverse_d[axis] < 0;
        const __m256 o = _mm256_set1_ps(ray.o[axis]), inverse = _mm256_set1_ps(ray.inverse_d[axis]);
        const __m256 near_plane = _mm256_load_ps((down ? node.hi : node.lo)[axis]);
        const __m256 far_plane = _mm256_load_ps((down ? node.lo : node.hi)[axis]);
        enter = _mm256_max_ps(enter, _mm256_mul_ps(_mm256_sub_ps(near_plane, o), inverse));
        leave = _mm256_min_ps(leave, _mm256_mul_ps(_mm256_sub_ps(far_plane, o), inverse));
    }
    _mm256_store_ps(entry, enter);
    return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(enter, leave, _CMP_LE_OQ)));
}

HitBoxes quickest() { return __builtin_cpu_supports("avx2") ? hit_boxes_avx2 : hit_boxes_plain; }

}  // namespace
const HitBoxes hit_boxes = quickest();
#else
const HitBoxes hit_boxes = hit_boxes_plain;
#endif

}  // namespace cardioid::csg
