#include "csg/region/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "csg/leaves/solvers.hpp"
#include "csg/region/weld_counts.hpp"

namespace cardioid::csg {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Where the line meets the box; t0 > t1 where it does not.
std::pair<double, double> box_interval(const Box3d& box, const Vec3d& o, const Vec3d& d) {
    double t0 = -infinity, t1 = infinity;
    for (int axis = 0; axis < 3; ++axis) {
        const double inverse = 1 / d[axis];
        double a = (box.lo[axis] - o[axis]) * inverse, b = (box.hi[axis] - o[axis]) * inverse;
        if (inverse < 0) std::swap(a, b);
        t0 = a > t0 ? a : t0, t1 = b < t1 ? b : t1;  // NaN, on a face of the box, changes nothing
    }
    return {t0, t1};
}

}  // namespace

struct Sweep::Buffers {
    struct Node {
        float t;
        std::uint32_t child;
    };
    struct Count {
        std::uint64_t ray = 0;  ///< the sweep this count is of; another one's is at rest
        std::int32_t value = 0;
        std::int32_t change = 0;  ///< of a group of events that is being flipped
        bool queued = false;      ///< waits in `dirty`
    };
    std::vector<Node> nodes;     ///< of the hierarchy, not yet visited; the nearest last
    std::vector<Event> pending;  ///< of solved leaves, not yet swept; the nearest last
    EventList fresh;
    std::vector<Event> tied;
    std::vector<Count> counts;
    std::vector<std::uint32_t> dirty;  ///< gates whose inputs have changed, the lowest first
    std::uint64_t ray = 0;
    ThreadWeldCounts welds;

    Count& count_of(std::uint32_t number, const Gate& gate) noexcept {
        Count& count = counts[number];
        if (count.ray != ray) count = {ray, gate.at_rest, 0, false};
        return count;
    }
};

Sweep::Buffers& Sweep::buffers() noexcept {
    thread_local Buffers b;
    return b;
}

Sweep::Sweep(const SolidRegion& region, const Ray& ray)
    : region_(region), ray_(ray), buffers_(buffers()), box_ray_({}, {}), end_(ray.t_max) {
    const GateTree& gates = region.gates();
    ++buffers_.ray;
    buffers_.nodes.clear();
    buffers_.pending.clear();
    if (gates.gates.empty()) return;
    if (buffers_.counts.size() < gates.gates.size()) buffers_.counts.resize(gates.gates.size());
    exact_ = exact_along(region.tolerances(), ray);
    if (!region.bvh()) {
        solve_all();
    } else {
        const auto [t0, t1] = box_interval(gates.bounds.padded(region.tolerances().start), ray.o, ray.d);
        if (t0 > t1 || t1 < 0 || t0 > ray.t_max) return;
        entry_t_ = std::max(t0, 0.0);
        box_ray_ = {Vec3(ray.o + ray.d * entry_t_ - region.bvh()->centre()), Vec3(ray.d)};
        node_end_ = static_cast<float>(std::min(t1, ray.t_max) - entry_t_) * (1 + 1e-6F);
        buffers_.nodes.push_back({0, 0});
    }
    start();
}

/// Without an event of a part the ray stays outside, whatever the cutters do.
void Sweep::solve_all() noexcept {
    const auto count = static_cast<std::uint32_t>(region_.leaves().size());
    const auto& inputs = region_.gates().inputs;
    const std::uint32_t required = region_.gates().required;
    if (required != Gates::none) {
        solve(required);
        if (buffers_.pending.empty()) return;
    }
    for (std::uint32_t i = 0; i < count; ++i)
        if (!inputs[i].negated && i != required) solve(i);
    if (buffers_.pending.empty()) return;
    for (std::uint32_t i = 0; i < count; ++i)
        if (inputs[i].negated) solve(i);
}

/// Files an event by its distance; one behind the sweep flips its gates at once, for the root is false wherever that
/// matters.
inline void Sweep::take(double t, std::uint32_t input, std::uint32_t face, bool entering) noexcept {
    const Event event = make_event(t, input, face, entering);
    if (t < now_) return flip(event);
    std::vector<Event>& pending = buffers_.pending;
    std::size_t i = pending.size();
    pending.emplace_back();
    for (; i > 0 && t > pending[i - 1].t; --i) pending[i] = pending[i - 1];
    pending[i] = event;
}

/// Solves one leaf, the most common kinds without a call.
void Sweep::solve(std::uint32_t input) noexcept {
    const SolvedLeaf& leaf = region_.leaves()[input];
    if (leaf.solver == Solver::ball || leaf.solver == Solver::axis_box) {
        const Span span = leaf.solver == Solver::ball ? ball_span(leaf.t, leaf.a, ray_.o, ray_.d)
                                                      : axis_box_span(leaf.t, leaf.row[0], ray_.o, ray_.d);
        if (span.empty()) return;
        take(span.t0, input, span.face0, true);
        take(span.t1, input, span.face1, false);
        return;
    }
    EventList& fresh = buffers_.fresh;
    fresh.clear();
    append_events(leaf, input, ray_.o, ray_.d, fresh);
    for (const Event& event : fresh) take(event.t, input, event.face, event.entering != 0);
}

/// Visits the nearest node of the hierarchy.
void Sweep::visit() noexcept {
    auto& nodes = buffers_.nodes;
    const std::uint32_t child = nodes.back().child;
    nodes.pop_back();
    if (child & Bvh8::leaf_flag) {
        const std::uint32_t first = (child & ~Bvh8::leaf_flag) >> 3;
        for (std::uint32_t i = first; i < first + (child & 7); ++i) solve(region_.bvh()->order()[i]);
        return;
    }
    alignas(32) float entry[8];
    const BvhNode& node = region_.bvh()->node(child);
    for (unsigned mask = hit_boxes(node, box_ray_, 0, node_end_, entry); mask; mask &= mask - 1) {
        const auto i = static_cast<unsigned>(__builtin_ctz(mask));
        const float t = entry[i];
        const std::uint32_t below = node.child[i];
        std::size_t k = nodes.size();
        nodes.emplace_back();
        for (; k > 0 && t > nodes[k - 1].t; --k) nodes[k] = nodes[k - 1];
        nodes[k] = {t, below};
    }
}

/// Solves every leaf that may have an event up to t.
void Sweep::visit_until(double t) noexcept {
    while (!buffers_.nodes.empty() && buffers_.nodes.back().t + entry_t_ <= t) visit();
}

void Sweep::start() noexcept {
    std::vector<Event>& pending = buffers_.pending;
    visit_until(ray_.from.region == FaceId::none ? 0 : most_spread * region_.tolerances().start);
    std::vector<Event>& here = buffers_.tied;
    here.clear();
    const double reach = most_spread * region_.tolerances().start;
    std::size_t kept = pending.size();
    while (kept > 0 && (pending[kept - 1].t <= 0 || (ray_.from.region != FaceId::none && pending[kept - 1].t <= reach)))
        --kept;
    std::vector<Event>& behind = buffers_.fresh;
    behind.clear();
    std::size_t out = kept;
    for (std::size_t i = kept; i < pending.size(); ++i) {
        if (starts_here(ray_, region_.tolerances(), exact_, region_.leaves()[pending[i].leaf], pending[i]))
            here.push_back(pending[i]);
        else if (pending[i].t <= 0)
            behind.push_back(pending[i]);
        else
            pending[out++] = pending[i];
    }
    pending.resize(out);
    now_ = 0;
    flip_all(behind);
    inside_before_ = inside();
    flip_all(here);
    inside_after_ = inside();
}

bool Sweep::inside() const noexcept {
    const auto& gates = region_.gates().gates;
    const Buffers::Count& count = buffers_.counts[gates.size() - 1];
    return (count.ray == buffers_.ray ? count.value : gates.back().at_rest) >= gates.back().threshold;
}

/// Flips events that lie at one place: every gate they reach is looked at once, children before parents, so that a deep
/// chain of coincident faces costs no more than its length.
void Sweep::flip_all(std::span<const Event> events) noexcept {
    if (events.size() == 1) return flip(events[0]);
    std::vector<std::uint32_t>& dirty = buffers_.dirty;
    dirty.clear();
    const auto change = [&](std::uint32_t gate, std::int32_t by) {
        Buffers::Count& count = buffers_.count_of(gate, region_.gates().gates[gate]);
        count.change += by;
        if (count.queued) return;
        count.queued = true;
        dirty.push_back(gate);
        std::push_heap(dirty.begin(), dirty.end(), std::greater<>());
    };
    for (const Event& event : events) {
        const Input input = region_.gates().inputs[event.leaf];
        change(input.gate, (event.entering != 0) != (input.negated != 0) ? 1 : -1);
    }
    while (!dirty.empty()) {
        std::pop_heap(dirty.begin(), dirty.end(), std::greater<>());
        const std::uint32_t g = dirty.back();
        dirty.pop_back();
        const Gate& gate = region_.gates().gates[g];
        Buffers::Count& count = buffers_.counts[g];
        const bool was = count.value >= gate.threshold;
        count.value += count.change;
        count.change = 0, count.queued = false;
        const bool is = count.value >= gate.threshold;
        if (was != is && gate.parent != Gates::none) change(gate.parent, is ? 1 : -1);
    }
}

void Sweep::flip(const Event& event) noexcept {
    const Input input = region_.gates().inputs[event.leaf];
    std::int32_t change = (event.entering != 0) != (input.negated != 0) ? 1 : -1;
    for (std::uint32_t g = input.gate; g != Gates::none;) {
        const Gate& gate = region_.gates().gates[g];
        Buffers::Count& count = buffers_.count_of(g, gate);
        const bool was = count.value >= gate.threshold;
        count.value += change;
        const bool is = count.value >= gate.threshold;
        if (was == is) return;
        change = is ? 1 : -1;
        g = gate.parent;
    }
}

Vec3d Sweep::normal_of(const Event& event) const noexcept {
    return normal(region_.leaves()[event.leaf], event.face, ray_.o + ray_.d * event.t);
}

/// Moves all events that tie with the nearest one from `pending` to `tied`, and flips them.
void Sweep::take_tied() noexcept {
    std::vector<Event>& pending = buffers_.pending;
    buffers_.tied.clear();
    now_ = pending.back().t;
    while (!pending.empty() && pending.back().t <= now_ + exact_) {
        buffers_.tied.push_back(pending.back());
        pending.pop_back();
    }
    flip_all(buffers_.tied);
}

/// Of tied events the owner of the face: rather a part than a cutter, rather later in the file.
const Event& Sweep::owner() const noexcept {
    const auto rank = [&](const Event& e) { return std::pair(region_.gates().inputs[e.leaf].negated == 0, e.leaf); };
    return *std::max_element(buffers_.tied.begin(), buffers_.tied.end(),
                             [&](const Event& a, const Event& b) { return rank(a) < rank(b); });
}

/// Whether parallel faces within the weld tolerance undo the change that `opener` made; if so they are swept with it.
bool Sweep::cancelled(const Event& opener, const Vec3d& n) noexcept {
    const double weld = region_.tolerances().weld, facing = std::abs(dot(n, ray_.d));
    if (weld == 0) return false;
    const double reach = opener.t + weld / std::max(facing, 1 / most_spread);
    visit_until(reach);
    std::vector<Event>& pending = buffers_.pending;
    std::vector<Event>& taken = buffers_.tied;
    taken.clear();
    const bool changed = inside();
    for (std::size_t i = pending.size(); i-- > 0 && pending[i].t <= reach;) {
        if (pending[i].leaf == opener.leaf) continue;  // a thin part is no coincidence
        const Vec3d other = normal_of(pending[i]);
        const double gap = (pending[i].t - opener.t) * std::min(facing, std::abs(dot(other, ray_.d)));
        if (gap > weld || !parallel(n, other)) continue;
        flip(pending[i]);
        taken.push_back(pending[i]);
        if (inside() == changed) continue;
        std::erase_if(pending, [&](const Event& e) {
            return std::any_of(taken.begin(), taken.end(), [&](const Event& x) {
                return x.leaf == e.leaf && x.t == e.t && x.entering == e.entering;
            });
        });
        return true;
    }
    for (Event event : taken) {  // flips back
        event.entering = !event.entering;
        flip(event);
    }
    return false;
}

bool Sweep::next(Boundary& out) noexcept {
    std::vector<Event>& pending = buffers_.pending;
    for (;;) {
        while (!buffers_.nodes.empty() &&
               (pending.empty() || buffers_.nodes.back().t + entry_t_ <= pending.back().t + exact_))
            visit();
        if (pending.empty() || pending.back().t >= end_) return false;
        const bool was = inside();
        take_tied();
        if (inside() == was) {
            if (buffers_.tied.size() > 1) buffers_.welds.add_exact();
            continue;
        }
        const Event face = owner();
        const Vec3d n = normal_of(face);
        if (cancelled(face, n)) {
            buffers_.welds.add_welded();
            continue;
        }
        const bool towards = dot(n, ray_.d) < 0;
        out = {face.t, towards != was ? n : -n, face.leaf, !was};
        return true;
    }
}

}  // namespace cardioid::csg
