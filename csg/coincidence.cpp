#include "csg/coincidence.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

#include "csg/compile.hpp"
#include "csg/leaves/leaf.hpp"
#include "csg/region/solid_region.hpp"
#include "rt_core/api/parallel.hpp"

namespace cardioid::csg {
namespace {

constexpr double grazing = 1e-3;     ///< cosine below which distances along a line tell nothing
constexpr double leaf_visits = 2e7;  ///< that a search may take, roughly
constexpr int least_grid = 16, most_grid = 128;
constexpr std::array<double, 2> slant{0.0137, 0.0071};  ///< of lines, as a share of the box's sides

/// The leaves of a tree, ready to be met by lines, and the model they make.
struct Model {
    Model(const SolidTree& tree, bool six_digits, double sliver_share)
        : shapes(tree), whole(compile_whole(tree, six_digits)) {
        for (const Leaf& leaf : tree.leaves) {
            kept.push_back(shapes.shape_of(leaf));
            leaves.push_back(solve(leaf, kept.back().get()));
            boxes.push_back(leaf_bounds(tree, leaf));
            if (boxes.back().bounded()) box.include(boxes.back());
        }
        find_cutters(tree);
        // compile_whole() makes no other kind of region.
        if (whole) tolerances = static_cast<const SolidRegion&>(*whole).tolerances();
        if (whole && whole->bounds().bounded()) box = whole->bounds();
        if (box.empty()) return;
        const double size = std::max(box.diagonal(), max_component(max(abs(box.lo), abs(box.hi))));
        sliver = size * sliver_share;
    }

    void find_cutters(const SolidTree& tree) {
        std::vector<bool> negated(tree.nodes.size());
        cutter.resize(tree.leaves.size());
        for (std::size_t i = tree.nodes.size(); i-- > 0;) {  // parents before their children
            const SolidNode& node = tree.nodes[i];
            if (node.op == SolidOp::leaf) cutter[node.first] = negated[i];
            if (node.op == SolidOp::leaf) continue;
            for (std::uint32_t c = 0; c < node.count; ++c)
                negated[tree.children[node.first + c]] = negated[i] != (node.op == SolidOp::subtract && c > 0);
        }
    }

    ShapeMaker shapes;
    std::unique_ptr<Region> whole;
    std::vector<std::shared_ptr<const Shape>> kept;
    std::vector<SolvedLeaf> leaves;
    std::vector<Box3d> boxes;
    std::vector<bool> cutter;  ///< whether the leaf takes away
    Box3d box;                 ///< of the model, without what has no end
    Tolerances tolerances;
    double sliver = 0;  ///< thickness
};

struct Line {
    Vec3d o, d;
    double length;
};

/// Line (i, j) of grid x grid along an axis, from just outside the box to just outside its other side.
Line line_through(const Box3d& box, int axis, int grid, int i, int j) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const Vec3d size = box.size(), margin = size * 0.01;
    Vec3d from = box.lo - margin, to = box.hi + margin;
    const double x = (i + 0.5) / grid, y = (j + 0.5) / grid;
    from[u] = box.lo[u] + size[u] * (x - slant[0] / 2), to[u] = from[u] + size[u] * slant[0];
    from[v] = box.lo[v] + size[v] * (y - slant[1] / 2), to[v] = from[v] + size[v] * slant[1];
    return {from, normalize(to - from), length(to - from)};
}

bool misses(const Box3d& box, const Line& line) {
    double begin = 0, end = line.length;
    for (int axis = 0; axis < 3; ++axis) {
        const double a = (box.lo[axis] - line.o[axis]) / line.d[axis], b = (box.hi[axis] - line.o[axis]) / line.d[axis];
        begin = std::max(begin, std::min(a, b)), end = std::min(end, std::max(a, b));
    }
    return begin > end;
}

/// Where the line crosses leaves, sorted.
void cross_leaves(const Model& model, const Line& line, EventList& events) {
    events.clear();
    for (std::uint32_t l = 0; l < model.leaves.size(); ++l)
        if (!misses(model.boxes[l].padded(model.tolerances.start), line))
            append_events(model.leaves[l], l, line.o, line.d, events);
    std::erase_if(events, [&](const Event& e) { return !(e.t > 0 && e.t < line.length); });
    std::sort(events.begin(), events.end(),
              [](const Event& x, const Event& y) { return std::tie(x.t, x.leaf) < std::tie(y.t, y.leaf); });
}

/// A crossing with its normal.
struct Crossing {
    Vec3d p, n;
    double t, facing;
    std::uint32_t leaf;
};

Crossing crossing(const Model& model, const Line& line, const Event& e) {
    const Vec3d p = line.o + line.d * e.t, n = normal(model.leaves[e.leaf], e.face, p);
    return {p, n, e.t, std::abs(dot(n, line.d)), e.leaf};
}

/// How far apart two parallel faces of different leaves are, along their normal; nothing where they are no such pair.
std::optional<double> distance(const Crossing& x, const Crossing& y) {
    const double facing = std::min(x.facing, y.facing);
    if (x.leaf == y.leaf || facing < grazing || !parallel(x.n, y.n)) return std::nullopt;
    return (y.t - x.t) * facing;
}

/// Whether two faces at one place matter: a cutter ends where a part does, or the model is on either side of them.
bool matters(const Model& model, const Crossing& x, const Crossing& y) {
    if (model.cutter[x.leaf] != model.cutter[y.leaf]) return true;
    const Sides sides = model.whole->sides(x.p, x.n);
    return sides.front || sides.back;
}

NearFaces near_faces(NearFaces::Kind kind, const Crossing& x, const Crossing& y, double distance) {
    return {kind, std::min(x.leaf, y.leaf), std::max(x.leaf, y.leaf), x.p, distance, 1};
}

/// Neighbours along the line that are one face.
void find_coincident(const Model& model, const Line& line, const EventList& events, std::vector<NearFaces>& out) {
    const double most = std::max(model.tolerances.weld, model.tolerances.exact);
    for (std::size_t i = 0; i + 1 < events.size(); ++i) {
        if (events[i + 1].t - events[i].t > most / grazing) continue;
        const Crossing a = crossing(model, line, events[i]), b = crossing(model, line, events[i + 1]);
        const std::optional<double> apart = distance(a, b);
        if (apart && *apart <= most && matters(model, a, b))
            out.push_back(near_faces(NearFaces::Kind::coincident, a, b, *apart));
    }
}

/// The crossing that made a boundary of the model.
const Event* event_at(const EventList& events, double t, double within) {
    const auto at = std::lower_bound(events.begin(), events.end(), t - within,
                                     [](const Event& e, double limit) { return e.t < limit; });
    return at != events.end() && at->t <= t + within ? &*at : nullptr;
}

/// Neighbouring boundaries of the model with next to nothing between them.
void find_slivers(const Model& model, const Line& line, const EventList& events, std::vector<Boundary>& boundaries,
                  std::vector<NearFaces>& out) {
    if (events.size() < 2) return;
    static_cast<const SolidRegion&>(*model.whole).boundaries({line.o, line.d, line.length, {}, {}}, boundaries);
    const double most = model.sliver, exact = 4 * model.tolerances.exact;
    for (std::size_t i = 0; i + 1 < boundaries.size(); ++i) {
        if (boundaries[i + 1].t - boundaries[i].t > most / grazing) continue;
        const Event* const x = event_at(events, boundaries[i].t, exact);
        const Event* const y = event_at(events, boundaries[i + 1].t, exact);
        if (!x || !y || x == y) continue;
        const Crossing a = crossing(model, line, *x), b = crossing(model, line, *y);
        const std::optional<double> thick = distance(a, b);
        if (!thick || *thick > most) continue;
        out.push_back(
            near_faces(boundaries[i].entering ? NearFaces::Kind::thin_solid : NearFaces::Kind::thin_gap, a, b, *thick));
    }
}

std::vector<NearFaces> search_row(const Model& model, int axis, int grid, int row) {
    std::vector<NearFaces> out;
    EventList events;
    std::vector<Boundary> boundaries;
    for (int j = 0; j < grid; ++j) {
        const Line line = line_through(model.box, axis, grid, row, j);
        cross_leaves(model, line, events);
        find_coincident(model, line, events, out);
        find_slivers(model, line, events, boundaries, out);
    }
    return out;
}

int grid_for(std::size_t leaves) {
    const double grid = std::sqrt(leaf_visits / (3 * static_cast<double>(std::max<std::size_t>(leaves, 1))));
    return std::clamp(static_cast<int>(grid), least_grid, most_grid);
}

}  // namespace

NearFaceReport find_near_faces(const SolidTree& tree, bool six_digits, double sliver_share) {
    NearFaceReport report;
    report.grid = grid_for(tree.leaves.size());
    const Model model(tree, six_digits, sliver_share);
    const Vec3d size = model.box.size();
    if (!model.whole || model.box.empty() || !(std::min({size.x, size.y, size.z}) > 0)) return report;
    std::vector<std::vector<NearFaces>> rows(static_cast<std::size_t>(3 * report.grid));
    parallel_for(3 * report.grid, [&](std::int64_t row) {
        const int number = static_cast<int>(row);
        rows[static_cast<std::size_t>(row)] =
            search_row(model, number / report.grid, report.grid, number % report.grid);
    });
    std::map<std::tuple<NearFaces::Kind, std::uint32_t, std::uint32_t>, NearFaces> all;
    for (const std::vector<NearFaces>& row : rows)
        for (const NearFaces& found : row) {
            const auto [at, fresh] = all.try_emplace({found.kind, found.a, found.b}, found);
            if (fresh) continue;
            ++at->second.lines;
            at->second.distance = std::max(at->second.distance, found.distance);
        }
    for (const auto& [key, pair] : all) report.pairs.push_back(pair);
    return report;
}

}  // namespace cardioid::csg
