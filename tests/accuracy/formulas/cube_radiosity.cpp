#include "tests/accuracy/formulas/cube_radiosity.hpp"

#include <algorithm>
#include <map>
#include <numbers>
#include <tuple>

namespace cardioid::test {

namespace {

constexpr std::array<int, 6> axis_of{2, 2, 0, 0, 1, 1};
constexpr std::array<double, 6> place_of{0, 1, 0, 1, 0, 1};

std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// From a point to the corner rectangle [0, x] x [0, y] in a parallel plane at distance 1.
double parallel_corner(double x, double y) {
    const double a = std::sqrt(x * x + 1), b = std::sqrt(y * y + 1);
    return (x / a * std::atan(y / a) + y / b * std::atan(x / b)) / (2 * std::numbers::pi);
}

/// From a point to the rectangle of width y and height z that stands at distance x, one corner straight before it.
double upright_corner(double y, double z, double x) {
    const double d = std::hypot(x, z);
    return (std::atan(y / x) - x / d * std::atan(y / d)) / (2 * std::numbers::pi);
}

/// Irradiance of a source of power 1 in the centre of the cube.
double source_irradiance(Vec3d p) {
    const double d = length(p - Vec3d(0.5, 0.5, 0.5));
    return 0.5 / (4 * std::numbers::pi * d * d * d);
}

double dot_of(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

}  // namespace

CubeRadiosity::CubeRadiosity(int patches) : patches_(patches) {
    for (int i = 0; i <= patches; ++i) {
        const double s = std::sin(std::numbers::pi * i / (2 * patches));
        edges_.push_back(s * s);
    }
    const auto middle = [&](int i) { return (edges_[index(i)] + edges_[index(i + 1)]) / 2; };
    for (int face = 0; face < 6; ++face)
        for (int i = 0; i < patches * patches; ++i) {
            const int axis = axis_of[index(face)];
            Vec3d p;
            p[axis] = place_of[index(face)];
            p[axis == 0 ? 1 : 0] = middle(i / patches);
            p[axis == 2 ? 1 : 2] = middle(i % patches);
            centres_.push_back(p);
            rows_.push_back(factors(face, p));
        }
}

std::vector<double> CubeRadiosity::factors(int face, Vec3d p) const {
    std::vector<double> row;
    row.reserve(patch_count());
    const int axis = axis_of[index(face)];
    std::vector<double> corner(edges_.size() * edges_.size());
    for (int other = 0; other < 6; ++other) {
        const int across = axis_of[index(other)], s = across == 0 ? 1 : 0, t = across == 2 ? 1 : 2;
        const double distance = std::abs(p[across] - place_of[index(other)]);
        for (std::size_t i = 0; i < edges_.size(); ++i)
            for (std::size_t j = 0; j < edges_.size(); ++j) {
                const auto along = [&](int a, double edge) {
                    return a == axis ? std::abs(edge - place_of[index(face)]) : edge - p[a];
                };
                const double x = along(s, edges_[i]), y = along(t, edges_[j]);
                corner[i * edges_.size() + j] =
                    across != axis  ? (s == axis ? upright_corner(y, x, distance) : upright_corner(x, y, distance))
                    : other != face ? parallel_corner(x, y)
                                    : 0;
            }
        for (std::size_t i = 0; i + 1 < edges_.size(); ++i)
            for (std::size_t j = 0; j + 1 < edges_.size(); ++j) {
                const std::size_t at = i * edges_.size() + j, next = at + edges_.size();
                row.push_back(std::abs(corner[next + 1] - corner[next] - corner[at + 1] + corner[at]));
            }
    }
    return row;
}

std::vector<double> CubeRadiosity::solve(const SixFaces& reflectance, const SixFaces& emission, double source) const {
    const auto face_of = [&](std::size_t i) { return i / (patch_count() / 6); };
    std::vector<double> own(patch_count());
    for (std::size_t i = 0; i < own.size(); ++i)
        own[i] = emission[face_of(i)] + reflectance[face_of(i)] * source * source_irradiance(centres_[i]);
    std::vector<double> radiosity = own;
    // Gauss and Seidel; each sweep takes the error down by the largest reflectance or more.
    const double largest = *std::max_element(own.begin(), own.end());
    for (double change = largest; change > 1e-9 * largest;) {
        change = 0;
        for (std::size_t i = 0; i < own.size(); ++i) {
            const double next = own[i] + reflectance[face_of(i)] * dot_of(rows_[i], radiosity);
            change = std::max(change, std::abs(next - radiosity[i]));
            radiosity[i] = next;
        }
    }
    return radiosity;
}

double CubeRadiosity::irradiance(const std::vector<double>& radiosity, double source, int face, Vec3d p) const {
    return dot_of(factors(face, p), radiosity) + source * source_irradiance(p);
}

double cube_irradiance(const SixFaces& reflectance, const SixFaces& emission, double source, int face, Vec3d p) {
    struct Solved {
        CubeRadiosity cube;
        std::map<std::tuple<SixFaces, SixFaces, double>, std::vector<double>> known;
        double at(const SixFaces& rho, const SixFaces& M, double phi, int f, Vec3d q) {
            std::vector<double>& radiosity = known[{rho, M, phi}];
            if (radiosity.empty()) radiosity = cube.solve(rho, M, phi);
            return cube.irradiance(radiosity, phi, f, q);
        }
    };
    static Solved coarse{CubeRadiosity(8), {}}, fine{CubeRadiosity(16), {}};
    const double a = coarse.at(reflectance, emission, source, face, p);
    const double b = fine.at(reflectance, emission, source, face, p);
    return b + (b - a) / 3;
}

}  // namespace cardioid::test
