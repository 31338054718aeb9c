#pragma once
#include <string>
#include <vector>

#include "shaders/lights/lat_long.hpp"

namespace cardioid::shaders {

/// Radiance of all directions from a latitude-longitude picture, linear between pixel centres, with a density that
/// follows it.
class SkyImage {
public:
    /// Reads by OpenImageIO; pictures of 8 and 16 bits are taken as sRGB. Negative and non-finite pixels count as
    /// black. where: "file:line:column" for messages. Throws Error(io, limit).
    SkyImage(const std::string& path, const std::string& where);

    [[nodiscard]] Rgb radiance(Vec3 d) const noexcept;
    [[nodiscard]] const LatLongDensity& density() const noexcept { return density_; }
    /// Of the radiance over all directions.
    [[nodiscard]] Rgb integral() const noexcept { return integral_; }

private:
    [[nodiscard]] Rgb pixel(std::ptrdiff_t x, std::ptrdiff_t y) const noexcept;
    /// Mean of the interpolated picture over a pixel's cell.
    [[nodiscard]] Rgb cell_mean(std::ptrdiff_t x, std::ptrdiff_t y) const noexcept;

    std::ptrdiff_t width_ = 0, height_ = 0;
    std::vector<Rgb> pixels_;
    LatLongDensity density_;
    Rgb integral_;
};

}  // namespace cardioid::shaders
