#pragma once
#include <span>

#include "photon/map/tree/point_query.hpp"

namespace cardioid::photon {

/// A photon of a disc as the test sees it.
struct DiscPhoton {
    float x, y;  ///< in the plane, relative to the disc's centre
    float d2;    ///< squared distance as the query measured it
    float flux;  ///< any measure of it, >= 0
    std::uint32_t index;
};

/// Sums over the photons of a disc that tell whether they lie evenly: where it has light of equal strength everywhere,
/// each moment has the mean 0 and a variance known from the fluxes alone (scores of linear and quadratic trends).
class DiscMoments {
public:
    void add(const DiscPhoton& photon) noexcept;
    /// Whether the photons so far may lie evenly in a disc of that squared radius. Two tests: of a trend from the
    /// centre to the rim, which is what makes a mean over the disc wrong (2.5 standard deviations), and of slope and
    /// ellipticity, which tell of edges and lines near by (chi-squared of four degrees of freedom, 12: 1.7 %).
    [[nodiscard]] bool even(float r2) const noexcept;

private:
    float flux_ = 0, flux2_ = 0;  ///< sums of flux and its square
    float x_ = 0, y_ = 0, spread_ = 0, ellipse_x_ = 0, ellipse_y_ = 0;
};

/// How many of the photons, which are reordered by distance ring by ring, make the largest even disc: at least `least`
/// or all, then growing by the square root of two as long as every disc is even (a rule of nested tests, after Lepski
/// 1991). The last of those is the farthest. Deterministic; O(n).
[[nodiscard]] std::uint32_t largest_even_disc(std::span<DiscPhoton> photons, std::uint32_t least) noexcept;

}  // namespace cardioid::photon
