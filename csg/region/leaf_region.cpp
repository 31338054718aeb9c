#include "csg/region/leaf_region.hpp"

#include "csg/leaves/solvers.hpp"

namespace cardioid::csg {

LeafRegion::LeafRegion(const SolvedLeaf& leaf, const Box3d& bounds, const Tolerances& tolerances)
    : leaf_(leaf), bounds_(bounds), tolerances_(&tolerances) {}

Box3d LeafRegion::bounds() const noexcept { return bounds_; }

const EventList& LeafRegion::events(const Ray& ray) const noexcept {
    thread_local EventList list;
    list.clear();
    append_events(leaf_, 0, ray.o, ray.d, list);
    return list;
}

bool LeafRegion::first_of(const Event* begin, const Event* end, const Ray& ray, Hit& hit) const noexcept {
    const double exact = exact_along(*tolerances_, ray);
    // An event at the origin is the surface the ray leaves: after it the ray is on the other side, and that is all.
    for (const Event* event = begin; event != end; ++event) {
        if (event->t <= 0 || starts_here(ray, *tolerances_, exact, leaf_, *event)) continue;
        if (event->t >= ray.t_max) return false;
        const Vec3d n = normal(leaf_, event->face, ray.o + ray.d * event->t);
        hit.t = event->t;
        hit.ng = Vec3(event->entering == (dot(n, ray.d) < 0) ? n : -n);
        hit.id.face = hit.leaf = 0;
        return true;
    }
    return false;
}

bool LeafRegion::first_boundary(const Ray& ray, std::uint32_t self, Hit& hit) const noexcept {
    // Who leaves a convex solid outward does not meet it again.
    if (ray.from.region == self && is_convex(leaf_.solver) && dot(Vec3d(ray.from_ng), ray.d) > 0) return false;
    if (is_convex(leaf_.solver)) return first_of(convex_leaf_span(leaf_, ray.o, ray.d), ray, hit);
    const EventList& list = events(ray);
    return first_of(list.data(), list.data() + list.size(), ray, hit);
}

/// Without a list, which costs as much as the rest.
bool LeafRegion::first_of(const Span& span, const Ray& ray, Hit& hit) const noexcept {
    if (span.empty() || span.t1 <= 0 || span.t0 >= ray.t_max) return false;
    const Event both[2] = {make_event(span.t0, 0, span.face0, true), make_event(span.t1, 0, span.face1, false)};
    return first_of(both, both + 2, ray, hit);
}

Sides LeafRegion::sides(Vec3d p, Vec3d n) const noexcept {
    const Ray ray{p, -n, tolerances_->start, {0, 0}, Vec3(n)};
    const double exact = exact_along(*tolerances_, ray);
    Sides sides;
    for (const Event& event : events(ray)) {
        const bool here = starts_here(ray, *tolerances_, exact, leaf_, event);
        if (!here && event.t > 0) break;
        if (!here) sides.front = event.entering;
        sides.back = event.entering;
    }
    return sides;
}

std::size_t LeafRegion::memory_bytes() const noexcept {
    return sizeof(*this) + (leaf_.shape ? leaf_.shape->memory_bytes() : 0);
}

}  // namespace cardioid::csg
