#include "rt_core/render/lighting/light_choice.hpp"

#include <algorithm>
#include <numbers>

namespace cardioid {

namespace {

/// Neither the lights at infinity nor those with a place are asked less often than this share, where both are there.
constexpr double least_share = 0.05;
/// Nor either half of a node, so that a large node close by is not misjudged for good.
constexpr double least_half = 0.02;

bool is_far(const Light& light, Vec3d from) {
    for (unsigned i = 0; i < 16; ++i) {
        const Vec2 u{(static_cast<float>(i & 3) + 0.5F) / 4, (static_cast<float>(i >> 2) + 0.5F) / 4};
        const LightSample s = light.sample(from, u);
        if (std::isinf(s.distance) && !s.trace) return true;
    }
    return false;
}

/// Where its photons start.
Box3d box_of(const Light& light) {
    Box3d box;
    for (unsigned i = 0; i < 16; ++i) {
        const Vec2 u{(static_cast<float>(i & 3) + 0.5F) / 4, (static_cast<float>(i >> 2) + 0.5F) / 4};
        const LightEmission e = light.emit(u, {u.y, u.x});
        if (is_finite(e.ray.o) && !is_black(e.flux)) box.include(e.ray.o);
    }
    return box;
}

}  // namespace

LightChoice::LightChoice(const World& world) : lights_(world.lights().size()), leaf_(lights_, none) {
    const Box3d bounds = world.bounds();
    const Vec3d centre = bounds.empty() ? Vec3d{} : bounds.centre();
    const double radius = bounds.diagonal() > 0 ? bounds.diagonal() / 2 : 1;
    std::vector<Placed> placed;
    for (std::uint32_t i = 0; i < lights_; ++i) {
        const Light& light = *world.lights()[i];
        const double flux = luminance(light.power());
        if (!(flux > 0)) continue;
        if (is_far(light, centre)) {
            far_.push_back(i);
            far_cdf_.push_back((far_cdf_.empty() ? 0 : far_cdf_.back()) + flux / (std::numbers::pi * radius * radius));
            continue;
        }
        Box3d box = box_of(light);
        if (box.empty()) box.include(centre);
        placed.push_back({i, box, flux / (4 * std::numbers::pi)});
    }
    if (placed.empty()) return;
    nodes_.reserve(2 * placed.size());
    nodes_.emplace_back();
    build(0, placed);
}

void LightChoice::build(std::uint32_t node, std::span<Placed> lights) {
    Box3d box, centres;
    double flux = 0;
    for (const Placed& p : lights) box.include(p.box), centres.include(p.box.centre()), flux += p.flux;
    nodes_[node].centre = box.centre();
    nodes_[node].radius2 = box.diagonal() * box.diagonal() / 4;
    nodes_[node].flux = flux;
    if (lights.size() == 1) {
        nodes_[node].light = lights[0].light;
        leaf_[lights[0].light] = node;
        return;
    }
    const Vec3d size = centres.size();
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::size_t half = lights.size() / 2;
    std::nth_element(lights.begin(), lights.begin() + static_cast<std::ptrdiff_t>(half), lights.end(),
                     [axis](const Placed& a, const Placed& b) {
                         return std::pair(a.box.centre()[axis], a.light) < std::pair(b.box.centre()[axis], b.light);
                     });
    const auto left = static_cast<std::uint32_t>(nodes_.size());
    nodes_[node].left = left;
    nodes_.resize(nodes_.size() + 2);
    nodes_[left].parent = nodes_[left + 1].parent = node;
    build(left, lights.first(half));
    build(left + 1, lights.subspan(half));
}

double LightChoice::brightness(const Node& node, Vec3d p) noexcept {
    const Vec3d to = node.centre - p;
    const double d2 = std::max(dot(to, to), node.radius2);
    return node.flux / std::max(d2, 1e-300);
}

double LightChoice::chance_left(const Node& parent, Vec3d p) const noexcept {
    const double left = brightness(nodes_[parent.left], p), right = brightness(nodes_[parent.left + 1], p);
    const double share = left / (left + right);
    // Infinite over infinite, right at two lamps.
    return share >= 0 ? std::clamp(share, least_half, 1 - least_half) : 0.5;
}

double LightChoice::chance_far(Vec3d p) const noexcept {
    if (far_.empty() || nodes_.empty()) return far_.empty() ? 0 : 1;
    const double far = far_cdf_.back(), near = brightness(nodes_[0], p);
    return std::clamp(far / (far + near), least_share, 1 - least_share);
}

LightChoice::Choice LightChoice::choose(Vec3d p, float u) const noexcept {
    if (nodes_.size() == 1 && far_.empty()) return {nodes_[0].light, 1};
    if (nodes_.empty() && far_.empty()) return {};
    const double far = chance_far(p);
    double rest = u, chance = 1;
    // Splits the number between two ways and stretches what is left of it to [0, 1).
    const auto take = [&](double share) {
        const bool first = rest < share;
        rest = first ? rest / share : (rest - share) / (1 - share);
        chance *= first ? share : 1 - share;
        return first;
    };
    if (take(far)) {
        const double wanted = rest * far_cdf_.back();
        const auto at =
            static_cast<std::size_t>(std::upper_bound(far_cdf_.begin(), far_cdf_.end() - 1, wanted) - far_cdf_.begin());
        const double share = (far_cdf_[at] - (at == 0 ? 0 : far_cdf_[at - 1])) / far_cdf_.back();
        return {far_[at], static_cast<float>(chance * share)};
    }
    std::uint32_t node = 0;
    while (nodes_[node].left != 0) node = nodes_[node].left + (take(chance_left(nodes_[node], p)) ? 0 : 1);
    return {nodes_[node].light, static_cast<float>(chance)};
}

float LightChoice::chance(Vec3d p, std::size_t light) const noexcept {
    if (nodes_.size() == 1 && far_.empty()) return leaf_[light] == none ? 0 : 1;
    std::uint32_t node = leaf_[light];
    if (node != none) {
        double chance = 1 - chance_far(p);
        for (; node != 0; node = nodes_[node].parent) {
            const Node& parent = nodes_[nodes_[node].parent];
            const double left = chance_left(parent, p);
            chance *= node == parent.left ? left : 1 - left;
        }
        return static_cast<float>(chance);
    }
    const auto at = static_cast<std::size_t>(std::find(far_.begin(), far_.end(), light) - far_.begin());
    if (at == far_.size()) return 0;
    return static_cast<float>(chance_far(p) * (far_cdf_[at] - (at == 0 ? 0 : far_cdf_[at - 1])) / far_cdf_.back());
}

}  // namespace cardioid
