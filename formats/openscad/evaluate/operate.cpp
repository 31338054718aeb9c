#include "formats/openscad/evaluate/operate.hpp"

#include <cmath>

#include "csg/exact/evaluate_mesh.hpp"
#include "csg/exact/hull.hpp"
#include "csg/exact/minkowski/minkowski.hpp"
#include "csg/exact/section.hpp"
#include "csg/exact/tessellate.hpp"
#include "formats/openscad/geometry/plane_operations.hpp"
#include "formats/openscad/geometry/transforms.hpp"

namespace cardioid::formats::openscad {
namespace {

/// The chord error of curves that become meshes, as a share of the size of all they are made of.
constexpr double chord_share = 1e-4;

/// One operation over solids.
class SolidOperation {
public:
    SolidOperation(const Frame& frame, const State& outer, const Arguments& args, Results& results,
                   ShapeContext& context)
        : frame_(frame),
          outer_(outer),
          args_(args),
          results_(results),
          context_(context),
          nodes_(results.take_solids(frame.mark)) {
        for (const std::uint32_t node : nodes_) bounds_.include(csg::tight_bounds(tree(), node));
        tolerance_ = chord_share * (bounds_.bounded() ? bounds_.diagonal() : 1);
    }

    void run() {
        switch (frame_.node) {
            case Node::hull:
                return hull();
            case Node::minkowski:
                return minkowski();
            case Node::resize:
                return resize();
            case Node::projection:
                return projection();
            default:
                args_.fail("found a solid, wanted plane figures");
        }
    }

private:
    [[nodiscard]] const SolidTree& tree() const { return context_.solids; }

    void add_mesh(TriangleMesh mesh) {
        if (mesh.triangles.empty()) return;
        if (const auto shape = make_mesh(std::move(mesh), args_.where(), context_))
            results_.place(*shape, outer_.to_world, results_.material_of(nodes_[0]),
                           {args_.where(), frame_.ast->line(frame_.call->place)});
    }

    /// Whether the children are one leaf without dents, of a kind that OpenSCAD has.
    [[nodiscard]] bool is_convex() const {
        const SolidNode& node = tree().nodes[nodes_[0]];
        if (nodes_.size() > 1 || node.op != SolidOp::leaf) return false;
        const Leaf& leaf = tree().leaves[node.first];
        return leaf.kind == LeafKind::box || leaf.kind == LeafKind::sphere || leaf.kind == LeafKind::cone ||
               (leaf.kind == LeafKind::mesh && context_.hulls.contains(leaf.data));
    }

    void hull() {
        if (is_convex()) return keep(Affine{});
        std::vector<Vec3d> points;
        for (const std::uint32_t node : nodes_) {
            const std::vector<Vec3d> more = csg::spanning_points(tree(), node, tolerance_);
            points.insert(points.end(), more.begin(), more.end());
        }
        const std::size_t before = tree().meshes.size();
        add_mesh(csg::convex_hull(points));
        if (tree().meshes.size() > before) context_.hulls.insert(static_cast<std::uint32_t>(before));
    }

    void minkowski() {
        if (nodes_.size() == 1) return keep(Affine{});
        for (TriangleMesh& mesh : csg::minkowski(tree(), nodes_, tolerance_, context_.limits.minkowski))
            add_mesh(std::move(mesh));
    }

    void resize() {
        Box3d box;
        for (const std::uint32_t node : nodes_) box.include(csg::exact_bounds(tree(), node, tolerance_));
        if (!box.bounded()) args_.fail("resize() of a solid without an end");
        keep(Affine::scaling(resize_scale(args_, box.size(), 3)));
    }

    /// The children themselves, scaled.
    void keep(const Affine& by) {
        std::vector<Leaf>& leaves = context_.solids.leaves;
        for (std::size_t i = frame_.first_leaf; i < leaves.size(); ++i)
            leaves[i].to_world = outer_.to_world * by * leaves[i].to_world;
        if (!is_singular(outer_.to_world * by))
            for (const std::uint32_t node : nodes_) results_.add_node(node);
        else
            context_.warnings.add(args_.where(), "a solid is scaled by 0 or by what is not finite: removed");
    }

    void projection() {
        const double grid =
            grid_of(bounds_.bounded() ? max_component(max(abs(bounds_.lo), abs(bounds_.hi))) : 0, context_.options);
        const bool cut = args_.boolean("cut", false);
        const double shadow_tolerance = 10 * tolerance_;  // a boolean is computed, and curves make it slow
        std::vector<Plane> parts;
        for (const std::uint32_t node : nodes_) {
            Profile profile = cut ? csg::section(tree(), node, tolerance_, grid)
                                  : csg::shadow(csg::evaluate_mesh(tree(), node, shadow_tolerance), grid);
            if (!profile.empty()) parts.push_back({std::move(profile), true, {}});
        }
        if (!parts.empty()) add_plane(unite(parts, context_), outer_, args_, results_, context_);
    }

    const Frame& frame_;
    const State& outer_;
    const Arguments& args_;
    Results& results_;
    ShapeContext& context_;
    std::vector<std::uint32_t> nodes_;
    Box3d bounds_;
    double tolerance_;

public:
    static void add_plane(Plane plane, const State& outer, const Arguments& args, Results& results,
                          ShapeContext& context) {
        if (auto placed = carried(std::move(plane), outer.in_plane, args, context))
            results.add_plane(std::move(*placed));
    }
};

}  // namespace

Dimension operand_dimension(Node node) {
    if (node == Node::projection) return Dimension::solid;
    return node == Node::offset || node == Node::fill ? Dimension::plane : Dimension::unknown;
}

void operate(const Frame& frame, const State& outer, const Arguments& args, Results& results, ShapeContext& context) {
    if (results.has_solids(frame.mark)) return SolidOperation(frame, outer, args, results, context).run();
    if (!results.has_planes(frame.mark)) return;
    // Of solids OpenSCAD leaves out those that are empty.
    if (frame.node == Node::minkowski && frame.empty_child) return results.drop(frame.mark);
    if (auto plane = operate_on_planes(frame.node, results.take_planes(frame.mark), args, context))
        SolidOperation::add_plane(std::move(*plane), outer, args, results, context);
}

}  // namespace cardioid::formats::openscad
