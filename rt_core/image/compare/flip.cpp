#include "rt_core/image/compare/flip.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "rt_core/api/parallel.hpp"

namespace cardioid {

namespace {

using Plane = std::vector<float>;

/// Three channels of a picture, in whichever space.
struct Planes {
    std::array<Plane, 3> c;
};

/// Of X, Y and Z, of the white of sRGB (D65).
constexpr std::array<double, 3> white{0.950428545, 1, 1.088900371};
/// Linear sRGB to XYZ (IEC 61966-2-1), from the primaries and the white above.
constexpr std::array<std::array<double, 3>, 3> to_xyz{
    {{0.41238656, 0.35759149, 0.18045049}, {0.21263682, 0.71518298, 0.0721802}, {0.01933062, 0.11919716, 0.95037259}}};

using Triple = std::array<double, 3>;

Triple inverse_times(const std::array<Triple, 3>& m, const Triple& v) {
    const auto cofactor = [&](std::size_t i, std::size_t j) {
        const std::size_t a = (i + 1) % 3, b = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
        return m[a][c] * m[b][d] - m[a][d] * m[b][c];
    };
    const double det = m[0][0] * cofactor(0, 0) + m[0][1] * cofactor(0, 1) + m[0][2] * cofactor(0, 2);
    Triple out{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) out[i] += cofactor(j, i) * v[j] / det;
    return out;
}

Triple xyz(const Triple& rgb) {
    Triple out{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) out[i] += to_xyz[i][j] * rgb[j];
    return out;
}

/// The opponent space of the contrast sensitivity functions: luminance, red-green, blue-yellow, all linear.
Triple ycxcz(const Triple& rgb) {
    const Triple v = xyz(rgb);
    const double x = v[0] / white[0], y = v[1] / white[1], z = v[2] / white[2];
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

Triple rgb_of_ycxcz(const Triple& v) {
    const double y = (v[0] + 16) / 116, x = y + v[1] / 500, z = y - v[2] / 200;
    return inverse_times(to_xyz, {x * white[0], y * white[1], z * white[2]});
}

/// CIE 1976 L*a*b* with colours scaled by lightness, as they fade in the dark (Hunt 1952; section 4.2 of the paper).
Triple hunt_lab(const Triple& rgb) {
    const auto f = [](double t) {
        constexpr double delta = 6.0 / 29;
        return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0 / 29;
    };
    const Triple v = xyz(rgb);
    const double x = f(v[0] / white[0]), y = f(v[1] / white[1]), z = f(v[2] / white[2]);
    const double lightness = 116 * y - 16;
    return {lightness, 0.01 * lightness * 500 * (x - y), 0.01 * lightness * 200 * (y - z)};
}

/// Differences of lightness and of hue add up (Abasi et al. 2020).
double hyab(const Triple& a, const Triple& b) { return std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]); }

/// A symmetric or antisymmetric row of weights; the middle one is at `radius`.
struct Kernel {
    std::vector<double> w;
    [[nodiscard]] int radius() const { return static_cast<int>(w.size() / 2); }
};

template <class F>
Kernel sampled(int radius, F&& f) {
    Kernel kernel;
    for (int i = -radius; i <= radius; ++i) kernel.w.push_back(f(static_cast<double>(i)));
    return kernel;
}

double sum(const Kernel& kernel) {
    double s = 0;
    for (const double w : kernel.w) s += w;
    return s;
}

/// Positive weights sum to 1, negative ones to -1.
Kernel balanced(Kernel kernel) {
    double above = 0, below = 0;
    for (const double w : kernel.w) (w > 0 ? above : below) += w;
    for (double& w : kernel.w) w /= w > 0 ? above : below == 0 ? 1 : -below;
    return kernel;
}

Kernel unit(Kernel kernel) {
    const double s = sum(kernel);
    for (double& w : kernel.w) w /= s;
    return kernel;
}

/// Rows by one kernel, then columns by the other; the border's pixels go on outside.
class Filter {
public:
    Filter(int width, int height) : width_(width), height_(height) {}

    [[nodiscard]] Plane operator()(const Plane& in, const Kernel& across, const Kernel& down) const {
        return pass(pass(in, across, true), down, false);
    }

private:
    [[nodiscard]] Plane pass(const Plane& in, const Kernel& kernel, bool rows) const {
        Plane out(in.size());
        const int r = kernel.radius();
        parallel_for(height_, [&](std::int64_t row) {
            const int y = static_cast<int>(row);
            for (int x = 0; x < width_; ++x) {
                double s = 0;
                for (int i = -r; i <= r; ++i) {
                    const int px = rows ? std::clamp(x + i, 0, width_ - 1) : x;
                    const int py = rows ? y : std::clamp(y + i, 0, height_ - 1);
                    s += kernel.w[static_cast<std::size_t>(i + r)] * double{in[index(px, py)]};
                }
                out[index(x, y)] = static_cast<float>(s);
            }
        });
        return out;
    }
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    }
    int width_, height_;
};

/// Contrast sensitivity per channel: a sum of Gaussians a sqrt(pi/b) exp(-pi^2 x^2 / b) of x in degrees (table 1).
struct Sensitivity {
    double a1, b1, a2, b2;
};
constexpr std::array<Sensitivity, 3> sensitivities{
    {{1, 0.0047, 0, 1e-5}, {1, 0.0053, 0, 1e-5}, {34.1, 0.04, 13.5, 0.025}}};
constexpr double widest_b = 0.04;

Planes see(const Planes& in, const Filter& filter, double ppd) {
    const double pi2 = std::numbers::pi * std::numbers::pi;
    const int radius = static_cast<int>(std::ceil(3 * std::sqrt(widest_b / (2 * pi2)) * ppd));
    Planes out;
    for (std::size_t c = 0; c < 3; ++c) {
        const Sensitivity& s = sensitivities[c];
        const auto gauss = [&](double b) {
            return sampled(radius, [&](double x) { return std::exp(-pi2 * (x / ppd) * (x / ppd) / b); });
        };
        const Kernel first = gauss(s.b1), second = gauss(s.b2);
        const double w1 = s.a1 * std::sqrt(std::numbers::pi / s.b1) * sum(first) * sum(first);
        const double w2 = s.a2 * std::sqrt(std::numbers::pi / s.b2) * sum(second) * sum(second);
        out.c[c] = filter(in.c[c], unit(first), unit(first));
        if (w2 == 0) continue;
        const Plane wide = filter(in.c[c], unit(second), unit(second));
        for (std::size_t i = 0; i < wide.size(); ++i)
            out.c[c][i] = static_cast<float>((w1 * double{out.c[c][i]} + w2 * double{wide[i]}) / (w1 + w2));
    }
    return out;
}

/// Strength of edges and of points about each pixel (section 4.3), from luminance as 0 to 1.
struct Features {
    Plane edge, point;
};

Features find_features(const Plane& luminance, const Filter& filter, double ppd) {
    constexpr double width_deg = 0.082;
    const double sigma = 0.5 * width_deg * ppd;
    const int radius = static_cast<int>(std::ceil(3 * sigma));
    const auto bell = [&](double x) { return std::exp(-x * x / (2 * sigma * sigma)); };
    const Kernel smooth = unit(sampled(radius, bell));
    const Kernel slope = balanced(sampled(radius, [&](double x) { return -x * bell(x); }));
    const Kernel bend = balanced(sampled(radius, [&](double x) { return (x * x / (sigma * sigma) - 1) * bell(x); }));
    const auto magnitude = [&](const Kernel& kernel) {
        Plane x = filter(luminance, kernel, smooth);
        const Plane y = filter(luminance, smooth, kernel);
        for (std::size_t i = 0; i < x.size(); ++i) x[i] = std::hypot(x[i], y[i]);
        return x;
    };
    return {magnitude(slope), magnitude(bend)};
}

Planes opponent(std::span<const Rgb> picture) {
    Planes out;
    for (Plane& plane : out.c) plane.reserve(picture.size());
    const auto cut = [](float x) { return std::clamp(double{x}, 0.0, 1.0); };
    for (const Rgb& p : picture) {
        const Triple v = ycxcz({cut(p.r), cut(p.g), cut(p.b)});
        for (std::size_t c = 0; c < 3; ++c) out.c[c].push_back(static_cast<float>(v[c]));
    }
    return out;
}

/// What one picture looks like.
struct Seen {
    Planes colours;  ///< opponent, as far as an eye tells them apart
    Features features;
};

Seen look_at(std::span<const Rgb> picture, const Filter& filter, double ppd) {
    const Planes raw = opponent(picture);
    Plane luminance = raw.c[0];
    for (float& y : luminance) y = (y + 16) / 116;
    return {see(raw, filter, ppd), find_features(luminance, filter, ppd)};
}

Triple seen_lab(const Planes& planes, std::size_t i) {
    Triple rgb = rgb_of_ycxcz({double{planes.c[0][i]}, double{planes.c[1][i]}, double{planes.c[2][i]}});
    for (double& x : rgb) x = std::clamp(x, 0.0, 1.0);
    return hunt_lab(rgb);
}

/// Large differences are all alike, so they are squeezed (section 4.2, q_c, p_c, p_t).
double squeezed(double difference) {
    constexpr double exponent = 0.7, knee = 0.4, knee_value = 0.95;
    static const double largest = std::pow(hyab(hunt_lab({0, 1, 0}), hunt_lab({0, 0, 1})), exponent);
    const double e = std::pow(difference, exponent), limit = knee * largest;
    return e < limit ? knee_value / limit * e : knee_value + (e - limit) / (largest - limit) * (1 - knee_value);
}

float pixel_difference(const Seen& r, const Seen& t, std::size_t i) {
    const double colour = squeezed(hyab(seen_lab(r.colours, i), seen_lab(t.colours, i)));
    const double edge = std::abs(double{r.features.edge[i]} - double{t.features.edge[i]});
    const double point = std::abs(double{r.features.point[i]} - double{t.features.point[i]});
    const double feature = std::sqrt(std::min(1.0, std::max(edge, point) / std::numbers::sqrt2));
    return static_cast<float>(std::pow(std::clamp(colour, 0.0, 1.0), 1 - feature));
}

}  // namespace

std::vector<float> flip(std::span<const Rgb> reference, std::span<const Rgb> test, int width,
                        double pixels_per_degree) {
    if (reference.empty()) return {};
    const Filter filter(width, static_cast<int>(reference.size() / static_cast<std::size_t>(width)));
    const Seen r = look_at(reference, filter, pixels_per_degree), t = look_at(test, filter, pixels_per_degree);
    std::vector<float> out(reference.size());
    const auto columns = static_cast<std::size_t>(width);
    parallel_for(static_cast<std::int64_t>(out.size() / columns), [&](std::int64_t row) {
        const std::size_t first = static_cast<std::size_t>(row) * columns;
        for (std::size_t i = first; i < first + columns; ++i) out[i] = pixel_difference(r, t, i);
    });
    return out;
}

}  // namespace cardioid
