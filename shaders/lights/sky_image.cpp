#include "shaders/lights/sky_image.hpp"

#include "rt_core/api/error.hpp"
#include "rt_core/api/image.hpp"

namespace cardioid::shaders {
namespace {

/// A picture this large needs 5 GB with its density.
constexpr std::int64_t most_pixels = std::int64_t{1} << 28;

/// IEC 61966-2-1.
float linear_of_srgb(float v) { return v <= 0.04045F ? v / 12.92F : std::pow((v + 0.055F) / 1.055F, 2.4F); }

float clean(float v) { return std::isfinite(v) && v > 0 ? v : 0; }

RawImage read(const std::string& path, const std::string& where) {
    try {
        return read_raw_image(path, most_pixels);
    } catch (const Error& error) {
        throw Error(error.code(), where + ": sky image " + error.what());
    }
}

}  // namespace

SkyImage::SkyImage(const std::string& path, const std::string& where) {
    const RawImage image = read(path, where);
    const std::vector<float>& values = image.values;
    const std::size_t channels = image.channels.size();
    width_ = image.width, height_ = image.height;
    const auto count = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
    const auto value = [&](std::size_t i, std::size_t channel) {
        const float v = clean(values[i * channels + channel]);
        return image.encoded ? linear_of_srgb(v) : v;
    };
    pixels_.resize(count);
    for (std::size_t i = 0; i < count; ++i)
        pixels_[i] = channels >= 3 ? Rgb{value(i, 0), value(i, 1), value(i, 2)} : Rgb(value(i, 0));

    std::vector<Rgb> means(count);
    std::vector<float> weights(count);
    for (std::ptrdiff_t y = 0, i = 0; y < height_; ++y)
        for (std::ptrdiff_t x = 0; x < width_; ++x, ++i) {
            const auto at = static_cast<std::size_t>(i);
            means[at] = cell_mean(x, y);
            weights[at] = means[at].r + means[at].g + means[at].b;
        }
    density_ = LatLongDensity(static_cast<std::size_t>(width_), static_cast<std::size_t>(height_), weights);
    double sum[3] = {0, 0, 0};
    for (std::size_t i = 0; i < count; ++i) {
        const double solid_angle = density_.cell_solid_angle(i / static_cast<std::size_t>(width_));
        sum[0] += solid_angle * double{means[i].r};
        sum[1] += solid_angle * double{means[i].g};
        sum[2] += solid_angle * double{means[i].b};
    }
    integral_ = {static_cast<float>(sum[0]), static_cast<float>(sum[1]), static_cast<float>(sum[2])};
}

Rgb SkyImage::pixel(std::ptrdiff_t x, std::ptrdiff_t y) const noexcept {
    x = x < 0 ? x + width_ : x >= width_ ? x - width_ : x;
    y = std::clamp<std::ptrdiff_t>(y, 0, height_ - 1);
    return pixels_[static_cast<std::size_t>(y * width_ + x)];
}

Rgb SkyImage::cell_mean(std::ptrdiff_t x, std::ptrdiff_t y) const noexcept {
    constexpr float weight[3] = {0.125F, 0.75F, 0.125F};
    Rgb sum;
    for (std::ptrdiff_t j = 0; j < 3; ++j)
        for (std::ptrdiff_t i = 0; i < 3; ++i) sum += pixel(x + i - 1, y + j - 1) * (weight[i] * weight[j]);
    return sum;
}

Rgb SkyImage::radiance(Vec3 d) const noexcept {
    const Vec2d at = lat_long(d);
    const double x = at.x * static_cast<double>(width_) - 0.5, y = at.y * static_cast<double>(height_) - 0.5;
    const double x0 = std::floor(x), y0 = std::floor(y);
    const auto s = static_cast<float>(x - x0), t = static_cast<float>(y - y0);
    const auto i = static_cast<std::ptrdiff_t>(x0), j = static_cast<std::ptrdiff_t>(y0);
    return (pixel(i, j) * (1 - s) + pixel(i + 1, j) * s) * (1 - t) +
           (pixel(i, j + 1) * (1 - s) + pixel(i + 1, j + 1) * s) * t;
}

}  // namespace cardioid::shaders
