#include "csg/measure_area.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "csg/measure.hpp"
#include "rt_core/api/parallel.hpp"
#include "rt_core/math/sampler.hpp"

namespace cardioid::csg {
namespace {

/// Random numbers of one line, each in [0, 1).
class LineNumbers {
public:
    LineNumbers(std::uint32_t seed, std::int64_t line)
        : state_(mix64(mix64(seed) ^ static_cast<std::uint64_t>(line))) {}
    double next() { return 0x1p-53 * static_cast<double>((state_ = mix64(state_)) >> 11); }

private:
    std::uint64_t state_;
};

Vec3d on_sphere(LineNumbers& numbers) {
    const double z = 1 - 2 * numbers.next(), r = std::sqrt(1 - z * z), a = 2 * std::numbers::pi * numbers.next();
    return {r * std::cos(a), r * std::sin(a), z};
}

/// A chord of the unit ball between two independent points of its sphere is a line uniform in place and direction.
double crossings(const Region& region, Vec3d centre, double radius, LineNumbers numbers) {
    const Vec3d a = centre + on_sphere(numbers) * radius, b = centre + on_sphere(numbers) * radius;
    const double size = length(b - a);
    if (!(size > 0)) return 0;
    return 2 * static_cast<double>(inside_spans(region, a, (b - a) / size, size).size());
}

}  // namespace

AreaEstimate measure_area(const Region& region, const Box3d& box, std::int64_t lines, std::uint32_t seed) {
    if (box.empty() || lines < 2) return {};
    constexpr double margin = 1e-3;  // lines begin and end outside
    constexpr std::int64_t batch = 1024;
    const double radius = box.diagonal() / 2 * (1 + margin);
    struct Sums {
        double ones = 0, squares = 0;
    };
    std::vector<Sums> sums(static_cast<std::size_t>((lines + batch - 1) / batch));
    parallel_for(static_cast<std::int64_t>(sums.size()), [&](std::int64_t i) {
        Sums& sum = sums[static_cast<std::size_t>(i)];
        for (std::int64_t line = i * batch; line < std::min(lines, (i + 1) * batch); ++line) {
            const double n = crossings(region, box.centre(), radius, {seed, line});
            sum.ones += n, sum.squares += n * n;
        }
    });
    Sums all;
    for (const Sums& sum : sums) all.ones += sum.ones, all.squares += sum.squares;
    const double count = static_cast<double>(lines), mean = all.ones / count;
    const double variance = std::max(all.squares / count - mean * mean, 0.0) / (count - 1);
    const double scale = 2 * std::numbers::pi * radius * radius;  // half the sphere's surface
    return {scale * mean, scale * std::sqrt(variance), lines};
}

}  // namespace cardioid::csg
