#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "rt_core/render/film_sums.hpp"
#include "rt_core/render/tiles.hpp"

namespace cardioid {

/// Ends a render at a noise asked for, and says which tiles need how many samples for it.
///
/// The noise of a picture is the root mean square, over its pixels and channels, of (a - r) / sqrt(r^2 + f^2): a the
/// picture, r the truth, f = 0.7 (mean of sqrt(luminance))^2 a share of its level, so that pixels much darker
/// than it do not count beyond their worth and a lamp in sight does not count at all. A pixel takes half of its samples
/// from each of two sequences; half the difference of their means has the variance of the pixel, however its samples
/// are distributed, while errors estimated from samples of one well-spread sequence come out too large. For r stands
/// the median of the pixel and its neighbours, or, where that is more, what both sequences agree on: a pixel that a
/// rare bright sample has hit must not be excused by its own brightness.
///
/// The picture ends where that mean over all pixels is below the limit. No tile ends by itself: one that has not met
/// its rare bright samples looks quiet. Tiles only share what is still to be taken, by the square root of their
/// variance, which gives the least error for the work (Neyman 1934); it is taken over neighbouring tiles, and what
/// single pixels exceed it by far is shared by all tiles alike, as it may happen to any.
class NoisePlan {
public:
    /// limit: the noise to reach; most_samples: a pixel, even; crop and tiles as for morton_tiles(). Throws
    /// Error(limit) before anything is allocated where memory does not suffice.
    NoisePlan(double limit, std::uint32_t most_samples, const std::array<int, 4>& crop, std::span<const Tile> tiles);

    /// A sample of the first sequence has been added to the pixel.
    void add(std::size_t pixel, Rgb beauty) noexcept { first_[pixel] += beauty; }
    /// Measures the picture, whose tiles have `samples` a pixel each, at least 2, and plans the next pass.
    void measure(const FilmSums& sums, std::span<const std::uint32_t> samples);
    /// Samples a pixel that the next pass takes in the tile; even, 0 where none are due.
    [[nodiscard]] std::uint32_t wanted(std::size_t tile) const noexcept { return wanted_[tile]; }
    /// Whether the limit is reached, or no tile may take more.
    [[nodiscard]] bool done() const noexcept { return done_; }
    /// As last measured.
    [[nodiscard]] double noise() const noexcept { return noise_; }
    /// Share in [0, 1] of the samples taken that the limit is expected to need.
    [[nodiscard]] double share() const noexcept { return share_; }

private:
    [[nodiscard]] std::size_t pixel_of(int x, int y) const noexcept {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    }
    template <class Use>
    void each_pixel(const Tile& tile, Use&& use) const noexcept;
    [[nodiscard]] Rgb level_around(int x, int y) const noexcept;
    /// Fills errors_ with the squared error of each pixel; their mean.
    double measure_pixels(const FilmSums& sums, std::span<const std::uint32_t> samples);
    /// Variance of one sample in each tile, smoothed.
    [[nodiscard]] std::vector<double> variances(std::span<const std::uint32_t> samples) const;
    void plan(std::span<const double> variances, std::span<const std::uint32_t> samples);

    double limit_;
    std::uint32_t most_samples_;
    int width_, height_, columns_;
    std::vector<Tile> tiles_;             ///< relative to the crop
    std::vector<std::uint32_t> tile_at_;  ///< number of the tile in each place of their grid
    std::vector<Rgb> first_, means_;      ///< sums of the first sequence, and means of both
    std::vector<float> errors_;
    std::vector<std::uint32_t> wanted_;
    bool done_ = false;
    double noise_ = 0, share_ = 0;
};

}  // namespace cardioid
