#include "csg/region/solid_region.hpp"

#include <algorithm>

#include "csg/region/convex_parts.hpp"
#include "csg/region/sweep.hpp"

namespace cardioid::csg {
namespace {

/// Up to so many leaves it is quicker to solve them all than to visit a hierarchy (measured; csg.md: about 8).
constexpr std::size_t most_without_hierarchy = 8;

}  // namespace

SolidRegion::SolidRegion(Gates gates, std::vector<SolvedLeaf> leaves, std::vector<std::shared_ptr<const Shape>> shapes,
                         const Tolerances& tolerances)

    : gates_(std::move(static_cast<GateTree&>(gates))),
      leaves_(std::move(leaves)),
      shapes_(std::move(shapes)),
      tolerances_(tolerances) {
    std::erase(shapes_, nullptr);
    std::sort(shapes_.begin(), shapes_.end());
    shapes_.erase(std::unique(shapes_.begin(), shapes_.end()), shapes_.end());
    if (leaves_.size() > most_without_hierarchy && gates_.bounds.bounded()) {
        for (Box3d& box : gates.boxes) box = box.padded(tolerances.start);
        bvh_ = std::make_unique<const Bvh8>(gates.boxes, 2);
    }
    std::uint32_t first = Leaf::no_material;
    one_material_ = true;
    for (std::size_t i = 0; i < leaves_.size(); ++i) {
        if (gates_.inputs[i].negated) continue;
        if (first == Leaf::no_material) first = leaves_[i].material;
        one_material_ = one_material_ && leaves_[i].material == first;
    }
    one_and_ = is_one_and_of_convex(gates_, leaves_);
    leaves_.shrink_to_fit(), shapes_.shrink_to_fit();
    gates_.gates.shrink_to_fit(), gates_.inputs.shrink_to_fit();
}

bool SolidRegion::first_boundary(const Ray& ray, std::uint32_t, Hit& hit) const noexcept {
    Boundary b;
    const Answer quick = one_and_ ? first_by_intervals(*this, ray, b) : Answer::unsure;
    if (quick == Answer::none || (quick == Answer::unsure && !Sweep(*this, ray).next(b))) return false;
    hit.t = b.t;
    hit.ng = Vec3(b.ng);
    hit.id.face = hit.leaf = b.input;
    return true;
}

void SolidRegion::boundaries(const Ray& ray, std::vector<Boundary>& out) const {
    Sweep sweep(*this, ray);
    out.clear();
    for (Boundary b; sweep.next(b);) out.push_back(b);
}

Sides SolidRegion::sides(Vec3d p, Vec3d n) const noexcept {
    const Ray ray{p, -n, tolerances_.start, {0, 0}, Vec3(n)};
    const Sweep sweep(*this, ray);
    return {sweep.inside_before(), sweep.inside_after()};
}

bool SolidRegion::contains(Vec3d p) const noexcept {
    if (!gates_.bounds.contains(p)) return false;
    // An odd direction, so that rays along the faces of common models are rare.
    const Ray ray{p, normalize(Vec3d{0.5377, 0.6183, 0.5732}), 0, {}, {}};
    return Sweep(*this, ray).inside_after();
}

std::uint32_t SolidRegion::interior_material(Vec3d p) const noexcept {
    EventList events;
    const Vec3d d = normalize(Vec3d{0.5377, 0.6183, 0.5732});
    std::uint32_t last = 0;
    for (std::uint32_t i = 0; i < leaves_.size(); ++i) {
        if (gates_.inputs[i].negated) continue;
        last = leaves_[i].material;
        if (one_material_) break;
        events.clear();
        append_events(leaves_[i], i, p, d, events);
        if (std::count_if(events.begin(), events.end(), [](const Event& e) { return e.t > 0; }) % 2 != 0) break;
    }
    return last;
}

std::size_t SolidRegion::memory_bytes() const noexcept {
    std::size_t bytes = sizeof(*this) + leaves_.capacity() * sizeof(SolvedLeaf) +
                        gates_.gates.capacity() * sizeof(Gate) + gates_.inputs.capacity() * sizeof(Input) +
                        (bvh_ ? sizeof(Bvh8) + bvh_->memory_bytes() : 0) + shapes_.capacity() * sizeof(shapes_[0]);
    for (const auto& shape : shapes_) bytes += shape->memory_bytes();
    return bytes;
}

}  // namespace cardioid::csg
