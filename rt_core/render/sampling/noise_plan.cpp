#include "rt_core/render/sampling/noise_plan.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "rt_core/api/parallel.hpp"
#include "rt_core/render/memory_limit.hpp"

namespace cardioid {

namespace {

/// Samples a pixel of the first pass.
constexpr std::uint32_t first_pass = 8;
/// A small picture says little about its noise after few samples; it must have so many of them in all.
constexpr double fewest_samples = 8192;
/// By what share of what has been taken a pass grows the picture's samples at least, and those of a tile at most.
constexpr double least_growth = 1.0 / 16, most_growth = 0.5;
/// Pixels darker than this share of the picture's level count less and less. On pictures exposed for a screen it comes
/// near the tenth of white that comparisons of renderers use.
constexpr double dark_share = 0.7;
/// What a pixel's variance has beyond so many times the mean comes of rare samples, which other tiles may meet too.
constexpr double rare_share = 50;

float median3(float a, float b, float c) noexcept { return std::max(std::min(a, b), std::min(std::max(a, b), c)); }

/// Of the nine pixels around one: sorted within their rows, the lowest of the highs, the median of the middles and the
/// highest of the lows have the median between them (Smith 1996).
float median9(const float (&v)[9]) noexcept {
    float low[3], middle[3], high[3];
    for (int i = 0; i < 3; ++i) {
        const float a = v[3 * i], b = v[3 * i + 1], c = v[3 * i + 2];
        low[i] = std::min(std::min(a, b), c);
        middle[i] = median3(a, b, c);
        high[i] = std::max(std::max(a, b), c);
    }
    return median3(std::max(std::max(low[0], low[1]), low[2]), median3(middle[0], middle[1], middle[2]),
                   std::min(std::min(high[0], high[1]), high[2]));
}

double square(float x) noexcept { return static_cast<double>(x) * static_cast<double>(x); }

std::size_t pixels_of(const Tile& tile) noexcept {
    return static_cast<std::size_t>(tile.x1 - tile.x0) * static_cast<std::size_t>(tile.y1 - tile.y0);
}

}  // namespace

NoisePlan::NoisePlan(double limit, std::uint32_t most_samples, const std::array<int, 4>& crop,
                     std::span<const Tile> tiles)
    : limit_(limit),
      most_samples_(most_samples),
      width_(crop[2] - crop[0]),
      height_(crop[3] - crop[1]),
      columns_((width_ + tile_size - 1) / tile_size),
      tile_at_(tiles.size()) {
    const std::size_t pixels = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
    require_memory(static_cast<double>(pixels) * (2 * sizeof(Rgb) + sizeof(float)),
                   fmt::format("the noise of {} x {} pixels", width_, height_));
    first_.resize(pixels), means_.resize(pixels), errors_.resize(pixels);
    wanted_.assign(tiles.size(), std::min(first_pass, most_samples));
    for (const Tile& t : tiles) {
        const int column = (t.x0 - crop[0]) / tile_size, row = (t.y0 - crop[1]) / tile_size;
        tile_at_[static_cast<std::size_t>(row * columns_ + column)] = static_cast<std::uint32_t>(tiles_.size());
        tiles_.push_back({t.x0 - crop[0], t.y0 - crop[1], t.x1 - crop[0], t.y1 - crop[1]});
    }
}

template <class Use>
void NoisePlan::each_pixel(const Tile& tile, Use&& use) const noexcept {
    for (int y = tile.y0; y < tile.y1; ++y)
        for (int x = tile.x0; x < tile.x1; ++x) use(pixel_of(x, y), x, y);
}

Rgb NoisePlan::level_around(int x, int y) const noexcept {
    float r[9], g[9], b[9];
    int i = 0;
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx, ++i) {
            const Rgb& c = means_[pixel_of(std::clamp(x + dx, 0, width_ - 1), std::clamp(y + dy, 0, height_ - 1))];
            r[i] = c.r, g[i] = c.g, b[i] = c.b;
        }
    return {median9(r), median9(g), median9(b)};
}

double NoisePlan::measure_pixels(const FilmSums& sums, std::span<const std::uint32_t> samples) {
    const auto count = static_cast<std::int64_t>(tiles_.size());
    std::vector<double> of_tile(tiles_.size());
    const auto total = [&] {
        double sum = 0;
        for (const double x : of_tile) sum += x;
        return sum / static_cast<double>(means_.size());
    };
    parallel_for(count, [&](std::int64_t i) {
        const auto t = static_cast<std::size_t>(i);
        double roots = 0;
        each_pixel(tiles_[t], [&](std::size_t pixel, int, int) {
            means_[pixel] = sums.beauty_sum(pixel) * (1 / static_cast<float>(samples[t]));
            roots += static_cast<double>(std::sqrt(luminance(means_[pixel])));
        });
        of_tile[t] = roots;
    });
    const double floor = dark_share * dark_share * std::pow(total(), 4);  // f^2
    parallel_for(count, [&](std::int64_t i) {
        const auto t = static_cast<std::size_t>(i);
        const float scale = 2 / static_cast<float>(samples[t]);
        double sum = 0;
        each_pixel(tiles_[t], [&](std::size_t pixel, int x, int y) {
            const Rgb half = first_[pixel] * scale - means_[pixel], level = level_around(x, y);
            const Rgb mean = means_[pixel];
            const auto relative = [&](float error, float around, float own) {
                const float truth = std::max(around, own - std::abs(error));
                return error == 0 ? 0 : square(error) / (square(truth) + floor);
            };
            const double e = (relative(half.r, level.r, mean.r) + relative(half.g, level.g, mean.g) +
                              relative(half.b, level.b, mean.b)) *
                             (1.0 / 3);
            errors_[pixel] = static_cast<float>(e);
            sum += e;
        });
        of_tile[t] = sum;
    });
    return total();
}

std::vector<double> NoisePlan::variances(std::span<const std::uint32_t> samples) const {
    std::vector<double> own(tiles_.size());
    double mean = 0, rare = 0;
    for (std::size_t t = 0; t < tiles_.size(); ++t)
        each_pixel(tiles_[t], [&](std::size_t pixel, int, int) { mean += double{errors_[pixel]} * samples[t]; });
    mean /= static_cast<double>(errors_.size());
    for (std::size_t t = 0; t < tiles_.size(); ++t) {
        double sum = 0;
        each_pixel(tiles_[t], [&](std::size_t pixel, int, int) {
            const double variance = double{errors_[pixel]} * samples[t], common = std::min(variance, rare_share * mean);
            sum += common, rare += variance - common;
        });
        own[t] = sum / static_cast<double>(pixels_of(tiles_[t]));
    }
    rare /= static_cast<double>(errors_.size());
    std::vector<double> smooth(tiles_.size());
    const int rows = static_cast<int>(tiles_.size()) / columns_;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns_; ++column) {
            double sum = 0, n = 0;
            for (int y = std::max(row - 1, 0); y <= std::min(row + 1, rows - 1); ++y)
                for (int x = std::max(column - 1, 0); x <= std::min(column + 1, columns_ - 1); ++x, ++n)
                    sum += own[tile_at_[static_cast<std::size_t>(y * columns_ + x)]];
            smooth[tile_at_[static_cast<std::size_t>(row * columns_ + column)]] = sum / n + rare;
        }
    return smooth;
}

void NoisePlan::plan(std::span<const double> variances, std::span<const std::uint32_t> samples) {
    // The error is the mean of variance / samples, least at equal cost where samples go as the root of the variance.
    double roots = 0, taken = 0, pixels = 0;
    for (std::size_t t = 0; t < tiles_.size(); ++t) {
        const double n = static_cast<double>(pixels_of(tiles_[t]));
        roots += n * std::sqrt(variances[t]), taken += n * samples[t], pixels += n;
    }
    const double needed = std::max(roots * roots / pixels / (limit_ * limit_), fewest_samples);
    share_ = std::min(1.0, taken / needed);
    const double target = std::clamp(needed, (1 + least_growth) * taken, (1 + most_growth) * taken);
    bool more = false;
    for (std::size_t t = 0; t < tiles_.size(); ++t) {
        const double wanted = roots > 0 ? target * std::sqrt(variances[t]) / roots : target / pixels;
        const double lacking = std::clamp(wanted - samples[t], 0.0, most_growth * samples[t]);
        const auto pairs = static_cast<std::uint32_t>(std::ceil(lacking / 2));
        wanted_[t] = std::min(2 * pairs, most_samples_ - std::min(samples[t], most_samples_));
        more = more || wanted_[t] > 0;
    }
    done_ = !more;
}

void NoisePlan::measure(const FilmSums& sums, std::span<const std::uint32_t> samples) {
    noise_ = std::sqrt(measure_pixels(sums, samples));
    double taken = 0;
    for (std::size_t t = 0; t < tiles_.size(); ++t) taken += static_cast<double>(pixels_of(tiles_[t])) * samples[t];
    if (noise_ <= limit_ && taken >= fewest_samples) {
        std::fill(wanted_.begin(), wanted_.end(), 0U);
        share_ = 1, done_ = true;
        return;
    }
    plan(variances(samples), samples);
}

}  // namespace cardioid
