#include "csg/measure.hpp"

#include <array>
#include <cmath>
#include <limits>

#include "rt_core/api/parallel.hpp"
#include "rt_core/math/sampler.hpp"

namespace cardioid::csg {
namespace {

constexpr std::array<double, 2> slant{0.0137, 0.0071};  ///< shift of a line over the box, as a share of the box's sides
constexpr int most_boundaries = 1'000'000;              ///< of one line: stops a walk that does not get on
constexpr double grazing = 1e-6;                        ///< cosine below which a normal of single precision has no side

/// Lines through a box, nearly parallel to one of its sides, from just outside one face to just outside the opposite.
class LineGrid {
public:
    LineGrid(const Box3d& box, int axis, int grid, std::uint64_t seed)
        : axis_(axis), u_((axis + 1) % 3), v_((axis + 2) % 3), grid_(grid), seed_(seed) {
        const Vec3d size = box.size();
        const double height = size[axis_], margin = 0.01 * height;
        shift_[u_] = slant[0] * size[u_], shift_[v_] = slant[1] * size[v_], shift_[axis_] = height + 2 * margin;
        // Sheared lines sweep a wider rectangle than the box; shearing keeps volumes.
        corner_ = box.lo - shift_, corner_[axis_] = box.lo[axis_] - margin;
        width_[u_] = size[u_] + 2 * shift_[u_], width_[v_] = size[v_] + 2 * shift_[v_];
    }

    /// A random point of cell (i, j), on the plane where lines begin.
    [[nodiscard]] Vec3d origin(int i, int j) const {
        const std::uint64_t cell =
            static_cast<std::uint64_t>(i) * static_cast<std::uint64_t>(grid_) + static_cast<std::uint64_t>(j);
        const std::uint64_t a = mix64(seed_ ^ mix64(cell)), b = mix64(a);
        Vec3d o = corner_;
        o[u_] += width_[u_] * (i + 0x1p-53 * static_cast<double>(a >> 11)) / grid_;
        o[v_] += width_[v_] * (j + 0x1p-53 * static_cast<double>(b >> 11)) / grid_;
        return o;
    }
    [[nodiscard]] Vec3d direction() const { return normalize(shift_); }
    [[nodiscard]] double length() const { return cardioid::length(shift_); }
    /// Volume for which one unit of length on one line stands.
    [[nodiscard]] double volume_per_length() const {
        return width_[u_] * width_[v_] * direction()[axis_] / (static_cast<double>(grid_) * grid_);
    }

private:
    int axis_, u_, v_, grid_;
    std::uint64_t seed_;
    Vec3d shift_, corner_, width_;
};

double min_component(Vec3d v) { return std::min(v.x, std::min(v.y, v.z)); }

int shortest_side(Vec3d size) {
    const int xy = size.x < size.y ? 0 : 1;
    return size[xy] < size.z ? xy : 2;
}

/// The stretch of the line within the box; begin > end where it misses. No component of d is zero.
Span clip(const Box3d& box, Vec3d o, Vec3d d) {
    Span span{-Box3d::infinity, Box3d::infinity};
    for (int axis = 0; axis < 3; ++axis) {
        const double a = (box.lo[axis] - o[axis]) / d[axis], b = (box.hi[axis] - o[axis]) / d[axis];
        span.begin = std::max(span.begin, std::min(a, b));
        span.end = std::min(span.end, std::max(a, b));
    }
    return span;
}

/// Length of what of the spans lies in `within`.
double total(const std::vector<Span>& spans, Span within) {
    double sum = 0;
    for (const Span& span : spans)
        sum += std::max(0.0, std::min(span.end, within.end) - std::max(span.begin, within.begin));
    return sum;
}

/// Length of the line inside both the region and the box.
double chord_length(const Region& region, const Box3d& box, const LineGrid& lines, int i, int j) {
    const Vec3d o = lines.origin(i, j), d = lines.direction();
    const Span within = clip(box, o, d);
    return within.begin < within.end ? total(inside_spans(region, o, d, lines.length()), within) : 0;
}

/// Sum over disjoint pairs of neighbours of the squared difference: the variance of the sum of all, or more, for each
/// pair's difference holds the variances of both and what their means differ by.
double pair_variance(const std::vector<double>& chord, int grid) {
    double sum = 0;
    const auto at = [&](int i, int j) {
        return chord[static_cast<std::size_t>(i) * static_cast<std::size_t>(grid) + static_cast<std::size_t>(j)];
    };
    for (int i = 0; i < grid; ++i)
        for (int j = 0; j + 1 < grid; j += 2) sum += (at(i, j + 1) - at(i, j)) * (at(i, j + 1) - at(i, j));
    return sum;
}

}  // namespace

std::vector<Span> inside_spans(const Region& region, Vec3d o, Vec3d d, double length) {
    std::vector<Span> spans;
    Ray ray{o, d, length, {}, {}};
    double at = 0;
    bool inside = region.bounds().contains(o) && region.sides(o, d).front;
    if (inside) spans.push_back({0, length});
    for (int i = 0; i < most_boundaries; ++i) {
        Hit hit;
        ray.t_max = length - at;
        if (!(ray.t_max > 0) || !region.first_boundary(ray, 0, hit)) break;
        at += hit.t;
        const double facing = dot(Vec3d(hit.ng), d);
        const bool enters = std::abs(facing) > grazing ? facing < 0 : !inside;
        if (inside) spans.back().end = enters ? spans.back().begin : at;
        if (enters) spans.push_back({at, length});
        inside = enters;
        ray.o = o + d * at;
        ray.from = {0, hit.id.face};
        ray.from_ng = hit.ng;
    }
    // What ends nowhere is thinner than a ray's start can tell.
    if (inside && !region.bounds().contains(o + d * length)) spans.pop_back();
    return spans;
}

VolumeEstimate measure_volume(const Region& region, const Box3d& box, int grid, std::uint32_t seed) {
    if (box.empty() || !(min_component(box.size()) > 0)) return {};
    if (!box.bounded()) return {std::numeric_limits<double>::infinity(), 0, 0};
    const LineGrid lines(box, shortest_side(box.size()), grid, mix64(seed));
    std::vector<double> chord(static_cast<std::size_t>(grid) * static_cast<std::size_t>(grid));
    parallel_for(grid, [&](std::int64_t row) {
        const int i = static_cast<int>(row);
        for (int j = 0; j < grid; ++j)
            chord[static_cast<std::size_t>(i) * static_cast<std::size_t>(grid) + static_cast<std::size_t>(j)] =
                chord_length(region, box, lines, i, j);
    });
    double sum = 0;
    for (const double c : chord) sum += c;
    const double scale = lines.volume_per_length();
    return {sum * scale, std::sqrt(pair_variance(chord, grid)) * scale, static_cast<std::int64_t>(chord.size())};
}

Overlap measure_overlap(const Region& a, const Region& b, const Box3d& box, int grid, double least) {
    Overlap overlap;
    double volume = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const LineGrid lines(box, axis, grid, static_cast<std::uint64_t>(axis));
        const Vec3d d = lines.direction();
        for (int cell = 0; cell < grid * grid; ++cell) {
            const Vec3d o = lines.origin(cell / grid, cell % grid);
            for (const Span& in_a : inside_spans(a, o, d, lines.length()))
                for (const Span& in_b : inside_spans(b, o, d, lines.length())) {
                    const double begin = std::max(in_a.begin, in_b.begin), end = std::min(in_a.end, in_b.end);
                    if (end - begin <= least) continue;
                    volume += (end - begin) * lines.volume_per_length() / 3;
                    if (end - begin > overlap.depth)
                        overlap.depth = end - begin, overlap.where = o + d * ((begin + end) / 2);
                }
        }
    }
    overlap.volume = volume;
    return overlap;
}

}  // namespace cardioid::csg
