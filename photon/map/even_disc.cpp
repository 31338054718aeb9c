#include "photon/map/even_disc.hpp"

#include <algorithm>
#include <array>

namespace cardioid::photon {

namespace {

constexpr float growth = 1.41421356F;
/// Rings from the least disc to one of Neighbours::max_k photons.
constexpr std::size_t most_rings = 32;

bool nearer(const DiscPhoton& a, const DiscPhoton& b) noexcept {
    return a.d2 < b.d2 || (a.d2 == b.d2 && a.index < b.index);
}

}  // namespace

void DiscMoments::add(const DiscPhoton& photon) noexcept {
    const float x = photon.x, y = photon.y;
    flux_ += photon.flux;
    flux2_ += photon.flux * photon.flux;
    x_ += photon.flux * x;
    y_ += photon.flux * y;
    spread_ += photon.flux * photon.d2;
    ellipse_x_ += photon.flux * (x * x - y * y);
    ellipse_y_ += photon.flux * (2 * x * y);
}

bool DiscMoments::even(float r2) const noexcept {
    constexpr float trend_limit = 2.5F, shape_limit = 12;
    // Variances of t^2 - 1/2, of a coordinate, and of (x^2 - y^2) and 2xy in the unit disc: 1/12, 1/4 and 1/6.
    const float trend = spread_ / r2 - flux_ / 2;
    const float slope2 = (x_ * x_ + y_ * y_) / r2,
                ellipse2 = (ellipse_x_ * ellipse_x_ + ellipse_y_ * ellipse_y_) / (r2 * r2);
    return 12 * trend * trend <= trend_limit * trend_limit * flux2_ &&
           4 * slope2 + 6 * ellipse2 <= shape_limit * flux2_;
}

std::uint32_t largest_even_disc(std::span<DiscPhoton> photons, std::uint32_t least) noexcept {
    const auto all = static_cast<std::uint32_t>(photons.size());
    std::array<std::uint32_t, most_rings> sizes{};
    std::size_t rings = 0;
    for (float size = static_cast<float>(least); rings + 1 < most_rings; size *= growth) {
        sizes[rings] = std::min(static_cast<std::uint32_t>(size), all);
        if (sizes[rings++] == all) break;
    }
    for (std::size_t ring = rings; ring-- > 0;) {
        // The rim's photon comes to its place, the nearer ones before it.
        const std::uint32_t end = ring + 1 < rings ? sizes[ring + 1] : all;
        if (sizes[ring] > 0)
            std::nth_element(photons.begin(), photons.begin() + (sizes[ring] - 1), photons.begin() + end, nearer);
    }
    DiscMoments moments;
    std::uint32_t even = 0, next = 0;
    for (std::size_t ring = 0; ring < rings; ++ring) {
        if (sizes[ring] == 0) return 0;
        for (; next + 1 < sizes[ring]; ++next) moments.add(photons[next]);
        if (ring > 0 && !moments.even(photons[sizes[ring] - 1].d2)) return even;
        even = sizes[ring];
    }
    return even;
}

}  // namespace cardioid::photon
