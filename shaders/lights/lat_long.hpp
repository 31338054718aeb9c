#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "rt_core/api/math.hpp"

namespace cardioid::shaders {

/// Directions as points of a latitude-longitude picture, x and y in [0, 1]: +z is its top, its middle column faces +x,
/// and from the inside its right is to the right.
inline Vec2d lat_long(Vec3 d) noexcept {
    const double x = 0.5 - std::atan2(double{d.y}, double{d.x}) / (2 * std::numbers::pi);
    const double y = std::acos(std::clamp(double{d.z} / double{length(d)}, -1.0, 1.0)) / std::numbers::pi;
    return {x, y};
}

/// A density over all directions that is even within each cell of a latitude-longitude grid.
class LatLongDensity {
public:
    LatLongDensity() = default;
    /// weights: of each cell per steradian, rows from the top, none negative or infinite; if all are 0 nothing can be
    /// drawn.
    LatLongDensity(std::size_t width, std::size_t height, const std::vector<float>& weights)
        : width_(width), height_(height), row_cdf_(height + 1), cell_cdf_((width + 1) * height) {
        for (std::size_t y = 0; y < height; ++y) {
            double* cdf = &cell_cdf_[y * (width + 1)];
            for (std::size_t x = 0; x < width; ++x) cdf[x + 1] = cdf[x] + double{weights[y * width + x]};
            row_cdf_[y + 1] = row_cdf_[y] + cdf[width] * cell_solid_angle(y);
            for (std::size_t x = 1; x <= width && cdf[width] > 0; ++x) cdf[x] = x == width ? 1 : cdf[x] / cdf[width];
        }
        total_ = row_cdf_.back();
        for (std::size_t y = 1; y <= height && total_ > 0; ++y) row_cdf_[y] /= total_;
    }

    struct Drawn {
        Vec3 d;
        float pdf = 0;  ///< per steradian; 0: nothing
    };
    [[nodiscard]] Drawn sample(Vec2 u) const noexcept {
        if (!(total_ > 0)) return {};
        const auto [y, part_y] = invert(row_cdf_.data(), height_, double{u.y});
        const auto [x, part_x] = invert(&cell_cdf_[y * (width_ + 1)], width_, double{u.x});
        const double z = row_cos(y) + part_y * (row_cos(y + 1) - row_cos(y));
        const double r = std::sqrt(std::max(0.0, 1 - z * z));
        const double azimuth =
            2 * std::numbers::pi * (0.5 - (static_cast<double>(x) + part_x) / static_cast<double>(width_));
        return {Vec3(Vec3d{r * std::cos(azimuth), r * std::sin(azimuth), z}), cell_pdf(x, y)};
    }
    [[nodiscard]] float pdf(Vec3 d) const noexcept {
        if (!(total_ > 0)) return 0;
        const Vec2d at = lat_long(d);
        const auto cell = [](double t, std::size_t n) {
            return std::min(static_cast<std::size_t>(std::max(0.0, t) * static_cast<double>(n)), n - 1);
        };
        return cell_pdf(cell(at.x, width_), cell(at.y, height_));
    }
    [[nodiscard]] double cell_solid_angle(std::size_t y) const noexcept {
        return 2 * std::numbers::pi / static_cast<double>(width_) * (row_cos(y) - row_cos(y + 1));
    }

private:
    struct Place {
        std::size_t cell;
        double part;
    };
    /// The cell of the cumulated shares cdf[0..n] that u falls in, and where in it; never one of share 0.
    static Place invert(const double* cdf, std::size_t n, double u) noexcept {
        const double* upper = std::upper_bound(cdf + 1, cdf + n, u);
        auto i = static_cast<std::size_t>(upper - cdf) - 1;
        while (i > 0 && cdf[i + 1] <= cdf[i]) --i;
        const double share = cdf[i + 1] - cdf[i];
        return {i, share > 0 ? std::clamp((u - cdf[i]) / share, 0.0, 1.0) : 0.5};
    }
    [[nodiscard]] double row_cos(std::size_t y) const noexcept {
        return std::cos(std::numbers::pi * static_cast<double>(y) / static_cast<double>(height_));
    }
    [[nodiscard]] float cell_pdf(std::size_t x, std::size_t y) const noexcept {
        const double* cdf = &cell_cdf_[y * (width_ + 1)];
        const double share = (row_cdf_[y + 1] - row_cdf_[y]) * (cdf[x + 1] - cdf[x]);
        return static_cast<float>(share / cell_solid_angle(y));
    }

    std::size_t width_ = 0, height_ = 0;
    double total_ = 0;
    std::vector<double> row_cdf_, cell_cdf_;
};

}  // namespace cardioid::shaders
