#include <algorithm>
#include <cmath>

#include "formats/brlcad/scene/solids.hpp"

namespace cardioid::formats::brlcad {

namespace {

constexpr int nishimura = 0, inverse_square = 1, gaussian = 2;
/// Beyond the surface, as a share of its distance from the points.
constexpr double margin = 1e-6;

/// How far from the nearest of its points a metaball's surface may be: there all of them together are no more than the
/// threshold, as if each were no farther.
double reach_of(const std::vector<Blob>& blobs, int method, double threshold) {
    double squares = 0, greatest = 0;
    for (const Blob& blob : blobs)
        if (blob.strength > 0) {
            squares += blob.strength * blob.strength;
            greatest = std::max(greatest, blob.strength);
        }
    if (method == nishimura) return greatest;
    if (method == inverse_square) return std::sqrt(squares / threshold);
    const auto field = [&](double r) {
        double sum = 0;
        for (const Blob& blob : blobs)
            if (blob.strength > 0) sum += std::exp(blob.sharpness * (1 - r * r / (blob.strength * blob.strength)));
        return sum;
    };
    double lo = 0, hi = greatest;
    while (hi < 1e15 && field(hi) > threshold) hi *= 2;
    for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (lo + hi);
        (field(middle) > threshold ? lo : hi) = middle;
    }
    return hi;
}

std::optional<std::string> fault(const Solid& solid, const std::vector<Blob>& blobs, double threshold) {
    if (solid.method < nishimura || solid.method > gaussian)
        return "is of method " + std::to_string(solid.method) + ", which is not known, and is left out";
    if (!(threshold > 0)) return "has no threshold above 0, so no end, and is left out";
    if (solid.method == gaussian)
        for (const Blob& blob : blobs)
            if (!(blob.sharpness > 0)) return "has a point without a sharpness above 0, so no end, and is left out";
    return std::nullopt;
}

}  // namespace

std::optional<std::uint32_t> add_metaball(SolidTarget& target, const Solid& solid) {
    const auto& v = solid.numbers;
    const double threshold = v.empty() ? 0 : v[0];
    std::vector<Blob> blobs;
    for (std::size_t i = 1; i + 4 < v.size(); i += 5)
        if (v[i + 3] != 0) {
            // rt's gaussian field takes the square of the strength, so that none is negative.
            const double strength = solid.method == gaussian ? std::abs(v[i + 3]) : v[i + 3];
            blobs.push_back({{v[i], v[i + 1], v[i + 2]}, strength, v[i + 4]});
        }
    if (auto text = fault(solid, blobs, threshold)) {
        target.note = std::move(*text);
        return std::nullopt;
    }
    Box3d box;
    for (const Blob& blob : blobs)
        if (blob.strength > 0) box.include(blob.centre);
    const double reach = reach_of(blobs, solid.method, threshold);
    if (box.empty() || !(reach > 0)) {
        target.note = "has no volume";
        return std::nullopt;
    }
    const Vec3d middle = box.centre();
    const Vec3d size = box.size();
    const double half = 0.5 * std::max(size.x, std::max(size.y, size.z)) + reach * (1 + margin);
    for (Blob& blob : blobs) blob.centre = (blob.centre - middle) * (1 / half), blob.strength /= half;
    const Form form{.kind = FormKind::metaball,
                    .numbers = {static_cast<double>(solid.method), threshold},
                    .blobs = std::make_shared<const std::vector<Blob>>(std::move(blobs))};
    return add_leaf(target, {.kind = LeafKind::form,
                             .to_world = Affine::translation(middle) * Affine::scaling({half, half, half}),
                             .data = target.tree.add_form(form)});
}

}  // namespace cardioid::formats::brlcad
