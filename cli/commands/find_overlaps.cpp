#include <algorithm>
#include <fmt/format.h>
#include <memory>

#include "cli/commands/describe.hpp"
#include "cli/commands/find_faults.hpp"
#include "csg/compile.hpp"
#include "csg/measure.hpp"

namespace cardioid::cli {
namespace {

constexpr int lines_a_side = 16;  ///< of a grid along each axis, so 768 lines a pair
/// Numbers of six digits put a face this share of its coordinate beside where it was meant.
constexpr double touching = 1e-5;

/// An opaque solid at the top of the file.
struct Part {
    SolidTree tree;
    std::unique_ptr<Region> region;
    Box3d box;
    std::uint32_t statement = 0, material = 0;
};

std::vector<Part> opaque_parts(const Scene& scene, const CommittedScene& committed) {
    std::vector<Part> parts;
    for (std::size_t i = 0; i < scene.solids.roots.size(); ++i) {
        Part part;
        part.tree = subtree(scene.solids, scene.solids.roots[i]);
        part.region = csg::compile_whole(part.tree, scene.six_digits);
        if (!part.region) continue;
        part.box = part.region->bounds();
        part.statement = i < scene.statements.size() ? scene.statements[i] : static_cast<std::uint32_t>(i);
        part.material = part.tree.leaves[0].material == Leaf::no_material ? 0 : part.tree.leaves[0].material;
        if (!committed.materials()[part.material].shader->interior()) parts.push_back(std::move(part));
    }
    std::stable_sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.box.lo.x < b.box.lo.x; });
    return parts;
}

/// Where the file has it first.
bool stands_before(const Part& a, const Part& b) { return a.tree.leaves[0].line <= b.tree.leaves[0].line; }

void compare(const Part& a, const Part& b, const Scene& scene, Findings& findings) {
    if (a.statement == b.statement && a.material == b.material) return;
    const Box3d common = a.box.intersection(b.box);
    if (common.empty() || !common.bounded()) return;
    const double least = touching * std::max(max_component(abs(common.lo)), max_component(abs(common.hi)));
    const Vec3d size = common.size();
    if (std::min({size.x, size.y, size.z}) <= least) return;
    const csg::Overlap overlap = csg::measure_overlap(*a.region, *b.region, common, lines_a_side, least);
    if (!overlap.found()) return;
    const Part& first = stands_before(a, b) ? a : b;
    const Part& second = stands_before(a, b) ? b : a;
    findings.faults.push_back(
        {"overlap", fmt::format("{} and {} overlap at {}, about {:.3g} cubic units", solid_name(first.tree, scene),
                                solid_name(second.tree, scene), point_text(overlap.where), overlap.volume)});
}

}  // namespace

void find_overlaps(const Scene& scene, const CommittedScene& committed, Findings& findings) {
    const std::vector<Part> parts = opaque_parts(scene, committed);
    for (std::size_t i = 0; i < parts.size(); ++i)
        for (std::size_t j = i + 1; j < parts.size() && parts[j].box.lo.x <= parts[i].box.hi.x; ++j)
            compare(parts[i], parts[j], scene, findings);
}

}  // namespace cardioid::cli
