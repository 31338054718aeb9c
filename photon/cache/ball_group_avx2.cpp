#if defined(__x86_64__)
#include <immintrin.h>

#include "photon/cache/ball_group.hpp"

namespace cardioid::photon {

__attribute__((target("avx2"))) unsigned scan_balls_avx2(const BallGroup& g, const BallQuery& q, float* t) noexcept {
    const __m256 qnx = _mm256_set1_ps(q.n.x), qny = _mm256_set1_ps(q.n.y), qnz = _mm256_set1_ps(q.n.z);
    const __m256 gnx = _mm256_load_ps(g.nx), gny = _mm256_load_ps(g.ny), gnz = _mm256_load_ps(g.nz);
    const __m256 x = _mm256_set1_ps(q.p.x) - _mm256_load_ps(g.x), y = _mm256_set1_ps(q.p.y) - _mm256_load_ps(g.y),
                 z = _mm256_set1_ps(q.p.z) - _mm256_load_ps(g.z);
    const __m256 per_radius = _mm256_load_ps(g.per_radius), one = _mm256_set1_ps(1);
    const __m256 cosine = qnx * gnx + qny * gny + qnz * gnz;
    const __m256 distance = _mm256_sqrt_ps(x * x + y * y + z * z) * per_radius;
    const __m256 turn = _mm256_sqrt_ps(_mm256_max_ps(one - cosine, _mm256_setzero_ps()));
    const __m256 share = distance + turn * _mm256_set1_ps(q.per_turn);
    const __m256 height = x * (qnx + gnx) + y * (qny + gny) + z * (qnz + gnz);
    const __m256 off = _mm256_andnot_ps(_mm256_set1_ps(-0.0F), height) * per_radius;
    _mm256_storeu_ps(t, share);
    const __m256 within = _mm256_and_ps(_mm256_cmp_ps(share, one, _CMP_LT_OQ),
                                        _mm256_cmp_ps(off, _mm256_set1_ps(2 * ball_flatness), _CMP_LT_OQ));
    return static_cast<unsigned>(_mm256_movemask_ps(within));
}

}  // namespace cardioid::photon
#endif
