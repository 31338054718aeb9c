#include "rt_core/render/commit/media.hpp"

#include <algorithm>

namespace cardioid {

namespace {

/// Beyond so many transparent solids their boxes are taken to overlap rather than compared pair by pair.
constexpr std::size_t most_compared = 2000;

/// Keeps the medium that wins where both are present; solids are asked in file order.
void fill(const Medium*& place, const Medium* other) {
    if (other && (!place || other->priority > place->priority)) place = other;
}

bool same_to_light(const Medium& a, const Medium& b) { return a.ior == b.ior && a.absorption == b.absorption; }

bool any_overlap(std::span<const Box3d> boxes) {
    if (boxes.size() > most_compared) return true;
    for (std::size_t i = 0; i < boxes.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (boxes[i].overlaps(boxes[j])) return true;
    return false;
}

}  // namespace

Media::Media(const Tracer& tracer, std::span<const Material> materials) : tracer_(tracer), materials_(materials) {
    std::vector<Box3d> boxes;
    for (std::size_t i = 0; i < tracer.regions().size(); ++i) {
        const Region& region = *tracer.regions()[i];
        bool transparent = false;
        for (std::uint32_t leaf = 0; leaf < region.leaf_count() && !transparent; ++leaf)
            transparent = materials[region.material(leaf)].shader->interior() != nullptr;
        if (!transparent) continue;
        const Box3d box = region.bounds();
        // Points of a face lie a rounding error outside the box.
        const Vec3d margin = max(abs(box.lo), abs(box.hi)) * 1e-9;
        solids_.push_back({&region, static_cast<std::uint32_t>(i), {box.lo - margin, box.hi + margin}});
        boxes.push_back(solids_.back().bounds);
    }
    overlap_ = any_overlap(boxes);
    all_vacuum_ =
        std::none_of(materials.begin(), materials.end(), [](const Material& m) { return m.shader->interior(); });
}

const Medium* Media::interior(const Solid& solid, Vec3d p) const noexcept {
    return materials_[solid.region->interior_material(p)].shader->interior();
}

const Medium* Media::at(Vec3d p) const noexcept {
    const Medium* found = nullptr;
    for (const Solid& solid : solids_)
        if (solid.bounds.contains(p) && solid.region->sides(p, {0, 0, 1}).front) fill(found, interior(solid, p));
    return or_vacuum(found);
}

Interface Media::resolve(Vec3d p, const Hit& hit) const noexcept {
    const Medium *front = nullptr, *back = nullptr;
    const Vec3d n(hit.ng);
    for (const Solid& solid : solids_) {
        const bool own = solid.id == hit.id.region;
        if (!own && !solid.bounds.contains(p)) continue;
        const Sides sides = own ? Sides{.front = false, .back = true} : solid.region->sides(p, n);
        if (!sides.front && !sides.back) continue;
        const Medium* medium = interior(solid, p);
        if (sides.front) fill(front, medium);
        if (sides.back) fill(back, medium);
    }
    // A mesh that no region stands for encloses its own material.
    if (!tracer_.is_region(hit.id.region) && tracer_.lamp(hit.id.region) < 0)
        fill(back, materials_[tracer_.material(hit)].shader->interior());
    return {or_vacuum(front), or_vacuum(back)};
}

bool Media::hides(Vec3d p, const Hit& hit) const noexcept {
    if (tracer_.lamp(hit.id.region) >= 0 || !materials_[tracer_.material(hit)].shader->interior()) return false;
    const Interface sides = around(p, hit);
    // Air on both sides is no reason to hide a surface: thin filters stand in air.
    return same_to_light(*sides.front, *sides.back) && !same_to_light(*sides.front, vacuum);
}

}  // namespace cardioid
