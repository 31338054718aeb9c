#include <algorithm>
#include <fmt/format.h>
#include <memory>

#include "cli/check/find_faults.hpp"
#include "cli/commands/describe.hpp"
#include "csg/compile.hpp"
#include "csg/measure.hpp"
#include "rt_core/api/parallel.hpp"

namespace cardioid::cli {
namespace {

constexpr int lines_a_side = 16;  ///< of a grid along each axis, so 768 lines a pair
/// Numbers of six digits put a face this share of its coordinate beside where it was meant.
constexpr double touching = 1e-5;

/// A solid at the top of the file.
struct Part {
    SolidTree tree;
    std::unique_ptr<Region> region;
    Box3d box;
    std::string name;
    std::uint32_t statement = 0, material = 0;
    std::size_t order = 0;  ///< in the file
};

/// The last part of the name of a region of BRL-CAD, "box.r" of "/all.g/box.r".
std::string_view own_name(std::string_view path) { return path.substr(path.rfind('/') + 1); }

std::vector<Part> parts_of(const Scene& scene, const CommittedScene& committed) {
    std::vector<Part> parts;
    for (std::size_t i = 0; i < scene.solids.roots.size(); ++i) {
        Part part;
        part.tree = subtree(scene.solids, scene.solids.roots[i]);
        part.region = csg::compile_whole(part.tree, scene.six_digits);
        if (!part.region) continue;
        part.box = part.region->bounds();
        part.order = i;
        part.statement = i < scene.statements.size() ? scene.statements[i] : static_cast<std::uint32_t>(i);
        part.material = part.tree.leaves[0].material == Leaf::no_material ? 0 : part.tree.leaves[0].material;
        part.name = i < scene.names.size() ? scene.names[i] : solid_name(part.tree, scene);
        // Media may stand in each other; of a database, no two regions may.
        if (!scene.names.empty() || !committed.materials()[part.material].shader->interior())
            parts.push_back(std::move(part));
    }
    std::stable_sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.box.lo.x < b.box.lo.x; });
    return parts;
}

struct Pair {
    std::size_t a, b;
    Box3d common;
    double least;  ///< what is shorter only touches
    csg::Overlap overlap;
};

/// Whether the two may overlap, and their overlap would be worth telling.
bool worth_a_look(const Part& a, const Part& b, const Scene& scene, Pair& pair) {
    if (a.statement == b.statement && a.material == b.material) return false;
    if (!scene.names.empty() && own_name(a.name) == own_name(b.name)) return false;  // one region, drawn twice
    pair.common = a.box.intersection(b.box);
    if (pair.common.empty() || !pair.common.bounded()) return false;
    pair.least = touching * std::max(max_component(abs(pair.common.lo)), max_component(abs(pair.common.hi)));
    const Vec3d size = pair.common.size();
    return std::min({size.x, size.y, size.z}) > pair.least;
}

Finding describe(const Part& a, const Part& b, const csg::Overlap& overlap) {
    const Part& first = a.order < b.order ? a : b;
    const Part& second = a.order < b.order ? b : a;
    return {.kind = "overlap",
            .text = fmt::format("{} and {} overlap at {}, {:.4g} deep, about {:.3g} cubic units", first.name,
                                second.name, point_text(overlap.where), overlap.depth, overlap.volume),
            .at = overlap.where,
            .depth = overlap.depth,
            .volume = overlap.volume,
            .between = {first.name, second.name}};
}

}  // namespace

void find_overlaps(const Scene& scene, const CommittedScene& committed, bool one_union, Findings& findings) {
    const std::vector<Part> parts = parts_of(scene, committed);
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < parts.size(); ++i)
        for (std::size_t j = i + 1; j < parts.size() && parts[j].box.lo.x <= parts[i].box.hi.x; ++j)
            if (Pair pair{i, j, {}, 0, {}}; worth_a_look(parts[i], parts[j], scene, pair)) pairs.push_back(pair);
    parallel_for(static_cast<std::int64_t>(pairs.size()), [&](std::int64_t i) {
        Pair& pair = pairs[static_cast<std::size_t>(i)];
        pair.overlap =
            csg::measure_overlap(*parts[pair.a].region, *parts[pair.b].region, pair.common, lines_a_side, pair.least);
    });
    // The deepest first: it is what a person wants to see first.
    std::stable_sort(pairs.begin(), pairs.end(),
                     [](const Pair& a, const Pair& b) { return a.overlap.depth > b.overlap.depth; });
    for (const Pair& pair : pairs) {
        if (!pair.overlap.found()) continue;
        const Part &a = parts[pair.a], &b = parts[pair.b];
        (one_union ? findings.notes : findings.faults).push_back(describe(a, b, pair.overlap));
    }
}

}  // namespace cardioid::cli
