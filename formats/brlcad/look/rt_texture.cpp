#include "formats/brlcad/look/rt_texture.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>

namespace cardioid::formats::brlcad {

namespace {

constexpr double pi_d = std::numbers::pi;
constexpr int waves = 4;

/// An angle by its sine and cosine, which double without a call.
struct Turn {
    explicit Turn(double angle) : sine(std::sin(angle)), cosine(std::cos(angle)) {}
    void twice() {
        const double s = 2 * sine * cosine;
        cosine = 1 - 2 * sine * sine;
        sine = s;
    }
    double sine, cosine;
};

/// Single precision is a thousandth of what a pixel shows, in a third of the time.
double sine(double angle) { return static_cast<double>(std::sin(static_cast<float>(angle))); }

/// How thick clouds are at a place: sums of sines of growing frequency whose phases depend on the other coordinate
/// (Gardner 1984, "Simulation of natural scenes using textured quadric surfaces", eq. 1; the numbers of sh_cloud.c).
double thickness(double x, double y) {
    constexpr double contrast = 1, frequency_x = 2, frequency_y = 1, falling = 0.707;
    double fx = 2 * pi_d * frequency_x * x, fy = 2 * pi_d * frequency_y * y, weight = 1;
    double px = pi_d / 2 * sine(0.5 * fy), py = pi_d / 2 * sine(0.5 * fx), sum_x = 0, sum_y = 0;
    Turn along(fx), across(fy);
    for (int i = 0; i < waves; ++i) {
        sum_x += weight * sine(fx + px) + contrast;
        sum_y += weight * sine(fy + py) + contrast;
        px = pi_d / 2 * across.sine;
        py = pi_d / 2 * along.sine;
        along.twice(), across.twice();
        fx *= 2, fy *= 2, weight *= falling;
    }
    return sum_x * sum_y / (waves * 2 * waves);
}

Rgb cloud(Vec2d uv, double threshold, double range) {
    const double thick = std::clamp(thickness(uv.x, uv.y), 0.0, 1.0);
    const double clear = std::clamp(1 - (thick - threshold) / range, 0.0, 1.0);
    const auto mixed = [&](double sky) { return static_cast<float>((1 - clear) * thick + clear * sky); };
    return {mixed(0.31), mixed(0.31), mixed(0.78)};
}

bool odd(double x) { return std::fmod(std::floor(x), 2) != 0; }

}  // namespace

Rgb RtTexture::at(Vec2d uv) const noexcept {
    switch (kind) {
        case Kind::none:
            break;
        case Kind::checker:
            return odd(uv.x * scale) == odd(uv.y * scale) ? a : b;
        case Kind::cloud:
            return cloud(uv, threshold, range);
        case Kind::testmap:
            return {static_cast<float>(uv.x), 0, static_cast<float>(uv.y)};
        case Kind::image:
            return pixel(uv);
    }
    return Rgb(1);
}

Rgb RtTexture::pixel(Vec2d uv) const noexcept {
    const auto index = [](double x, std::size_t count) {
        const double part = x - std::floor(x);
        return static_cast<std::size_t>(part * static_cast<double>(count - 1));
    };
    const std::size_t i = index(uv.x * repeat_u, width), j = index(uv.y * repeat_v, height);
    const unsigned char* p = &pixels[3 * (j * width + i)];
    return Rgb(p[0], p[1], p[2]) * (1.0F / 255);
}

bool RtTexture::load(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    if (!in) return false;
    pixels.resize(3 * width * height);
    in.read(reinterpret_cast<char*>(pixels.data()), static_cast<std::streamsize>(pixels.size()));
    return in.gcount() == static_cast<std::streamsize>(pixels.size());
}

}  // namespace cardioid::formats::brlcad
