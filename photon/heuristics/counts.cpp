#include "photon/heuristics/counts.hpp"

#include <cmath>
#include <numbers>
#include <unistd.h>

namespace cardioid::photon {

std::uint32_t lookup_size(double error) {
    return static_cast<std::uint32_t>(std::ceil(1 / (error * error) - 1e-9)) + 2;
}

double count_for(double k, double radius, double density) {
    return density > 0 ? k / (std::numbers::pi * radius * radius * density) : 0;
}

double bytes_of(double stored) {
    // 32 a photon as it comes, and while the tree is built its points, normals and order once more.
    constexpr double most_at_once = 72;
    return stored * most_at_once;
}

double default_memory() {
    return 0.5 * static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

}  // namespace cardioid::photon
