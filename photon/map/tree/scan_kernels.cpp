#include <vector>

#include "photon/map/tree/scan.hpp"

namespace cardioid::photon {

#if defined(__x86_64__)
namespace {

std::vector<ScanKernels> usable() {
    std::vector<ScanKernels> kernels;
    if (__builtin_cpu_supports("avx512f")) kernels.push_back(avx512_kernels);
    if (__builtin_cpu_supports("avx2")) kernels.push_back(avx2_kernels);
    kernels.push_back(plain_kernels);
    return kernels;
}

}  // namespace
#else
namespace {

std::vector<ScanKernels> usable() { return {plain_kernels}; }

}  // namespace
#endif

std::span<const ScanKernels> usable_kernels() noexcept {
    static const std::vector<ScanKernels> kernels = usable();
    return kernels;
}

}  // namespace cardioid::photon
