#if defined(__x86_64__)
#if !defined(__clang__)
// GCC 12 takes the undefined lanes in its own intrinsics for variables that were forgotten.
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#pragma GCC diagnostic ignored "-Wuninitialized"
#endif
#include <immintrin.h>

#include "photon/map/tree/scan.hpp"

#define CARDIOID_VECTOR __attribute__((target("avx512f"))) inline

namespace cardioid::photon {

namespace {

/// Sixteen floats; sets of lanes are bits.
struct V {
    static constexpr std::uint32_t size = 16;
    using F = __m512;
    using I = __m512i;

    CARDIOID_VECTOR static F all(float x) { return _mm512_set1_ps(x); }
    CARDIOID_VECTOR static F load(const float* from) { return _mm512_loadu_ps(from); }
    CARDIOID_VECTOR static I load(const std::uint32_t* from) { return _mm512_loadu_si512(from); }
    CARDIOID_VECTOR static F low_half(const std::uint32_t* from) {
        return _mm512_cvtepi32_ps(_mm512_and_si512(load(from), _mm512_set1_epi32(0xFFFF)));
    }
    CARDIOID_VECTOR static F high_half(const std::uint32_t* from) {
        return _mm512_cvtepi32_ps(_mm512_srli_epi32(load(from), 16));
    }
    CARDIOID_VECTOR static F abs(F x) { return _mm512_abs_ps(x); }
    CARDIOID_VECTOR static F with_sign(F size_of, F sign_of) {
        const I sign = _mm512_and_si512(_mm512_castps_si512(sign_of), _mm512_set1_epi32(INT32_MIN));
        return _mm512_castsi512_ps(_mm512_or_si512(_mm512_castps_si512(abs(size_of)), sign));
    }
    CARDIOID_VECTOR static F max(F a, F b) { return _mm512_max_ps(a, b); }
    CARDIOID_VECTOR static float most(F x) { return _mm512_reduce_max_ps(x); }
    CARDIOID_VECTOR static unsigned less(F a, F b) { return _mm512_cmp_ps_mask(a, b, _CMP_LT_OQ); }
    CARDIOID_VECTOR static unsigned at_most(F a, F b) { return _mm512_cmp_ps_mask(a, b, _CMP_LE_OQ); }
    CARDIOID_VECTOR static unsigned equal(const std::uint32_t* a, std::uint32_t b) {
        return _mm512_cmpeq_epi32_mask(load(a), _mm512_set1_epi32(static_cast<int>(b)));
    }
    CARDIOID_VECTOR static F select(unsigned lanes, F a, F b) { return _mm512_mask_mov_ps(b, mask(lanes), a); }
    CARDIOID_VECTOR static I count_from(std::uint32_t first) {
        return _mm512_add_epi32(_mm512_set1_epi32(static_cast<int>(first)),
                                _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15));
    }
    /// Writes the chosen lanes, then anything. Not by compressing stores: on some processors those take 100 cycles.
    CARDIOID_VECTOR static void compress(float* to, F x, unsigned lanes) {
        _mm512_storeu_ps(to, _mm512_maskz_compress_ps(mask(lanes), x));
    }
    CARDIOID_VECTOR static void compress(std::uint32_t* to, I x, unsigned lanes) {
        _mm512_storeu_si512(to, _mm512_maskz_compress_epi32(mask(lanes), x));
    }

private:
    static __mmask16 mask(unsigned lanes) { return static_cast<__mmask16>(lanes); }
};

}  // namespace

}  // namespace cardioid::photon

#include "photon/map/tree/scan_vector.hpp"

namespace cardioid::photon {

const ScanKernels avx512_kernels{"avx512", scan, keep_smallest};

}  // namespace cardioid::photon
#endif
