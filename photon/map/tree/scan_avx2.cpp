#if defined(__x86_64__)
#include <array>
#include <immintrin.h>

#include "photon/map/tree/scan.hpp"

#define CARDIOID_VECTOR __attribute__((target("avx2"))) inline

namespace cardioid::photon {

namespace {

/// For each set of lanes, their numbers one after the other.
constexpr auto make_places() {
    std::array<std::array<std::uint8_t, 8>, 256> places{};
    for (unsigned lanes = 0; lanes < 256; ++lanes)
        for (std::uint8_t lane = 0, next = 0; lane < 8; ++lane)
            if (lanes >> lane & 1) places[lanes][next++] = lane;
    return places;
}
constexpr auto places_of = make_places();

/// Eight floats; sets of lanes are bits.
struct V {
    static constexpr std::uint32_t size = 8;
    using F = __m256;
    using I = __m256i;

    CARDIOID_VECTOR static F all(float x) { return _mm256_set1_ps(x); }
    CARDIOID_VECTOR static F load(const float* from) { return _mm256_loadu_ps(from); }
    CARDIOID_VECTOR static I load(const std::uint32_t* from) {
        return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(from));
    }
    CARDIOID_VECTOR static F low_half(const std::uint32_t* from) {
        return _mm256_cvtepi32_ps(_mm256_and_si256(load(from), _mm256_set1_epi32(0xFFFF)));
    }
    CARDIOID_VECTOR static F high_half(const std::uint32_t* from) {
        return _mm256_cvtepi32_ps(_mm256_srli_epi32(load(from), 16));
    }
    CARDIOID_VECTOR static F abs(F x) { return _mm256_andnot_ps(all(-0.0F), x); }
    CARDIOID_VECTOR static F with_sign(F size_of, F sign_of) {
        return _mm256_or_ps(abs(size_of), _mm256_and_ps(all(-0.0F), sign_of));
    }
    CARDIOID_VECTOR static F max(F a, F b) { return _mm256_max_ps(a, b); }
    CARDIOID_VECTOR static float most(F x) {
        __m128 m = _mm_max_ps(_mm256_castps256_ps128(x), _mm256_extractf128_ps(x, 1));
        m = _mm_max_ps(m, _mm_movehl_ps(m, m));
        return _mm_cvtss_f32(_mm_max_ss(m, _mm_movehdup_ps(m)));
    }
    CARDIOID_VECTOR static unsigned less(F a, F b) { return bits(_mm256_cmp_ps(a, b, _CMP_LT_OQ)); }
    CARDIOID_VECTOR static unsigned at_most(F a, F b) { return bits(_mm256_cmp_ps(a, b, _CMP_LE_OQ)); }
    CARDIOID_VECTOR static unsigned equal(const std::uint32_t* a, std::uint32_t b) {
        return bits(_mm256_castsi256_ps(_mm256_cmpeq_epi32(load(a), _mm256_set1_epi32(static_cast<int>(b)))));
    }
    CARDIOID_VECTOR static F select(unsigned lanes, F a, F b) {
        const I bit = _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128);
        const I chosen = _mm256_cmpeq_epi32(_mm256_and_si256(_mm256_set1_epi32(static_cast<int>(lanes)), bit), bit);
        return _mm256_blendv_ps(b, a, _mm256_castsi256_ps(chosen));
    }
    CARDIOID_VECTOR static I count_from(std::uint32_t first) {
        return _mm256_add_epi32(_mm256_set1_epi32(static_cast<int>(first)), _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7));
    }
    /// Writes the chosen lanes, then anything.
    CARDIOID_VECTOR static void compress(float* to, F x, unsigned lanes) {
        _mm256_storeu_ps(to, _mm256_permutevar8x32_ps(x, places(lanes)));
    }
    CARDIOID_VECTOR static void compress(std::uint32_t* to, I x, unsigned lanes) {
        _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), _mm256_permutevar8x32_epi32(x, places(lanes)));
    }

private:
    CARDIOID_VECTOR static unsigned bits(F x) { return static_cast<unsigned>(_mm256_movemask_ps(x)); }
    CARDIOID_VECTOR static I places(unsigned lanes) {
        return _mm256_cvtepu8_epi32(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(places_of[lanes].data())));
    }
};

}  // namespace

}  // namespace cardioid::photon

#include "photon/map/tree/scan_vector.hpp"

namespace cardioid::photon {

const ScanKernels avx2_kernels{"avx2", scan, keep_smallest};

}  // namespace cardioid::photon
#endif
