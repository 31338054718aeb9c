#include "formats/povray/solids/bounds.hpp"

#include "csg/leaves/forms.hpp"

namespace cardioid::formats::povray {

namespace {

Box3d profile_box(const Profile& profile) {
    Box3d box;
    for (const auto& contour : profile.contours)
        for (const Vec2d p : contour) box.include(Vec3d{p.x, p.y, 0});
    return box;
}

Box3d around_z(double radius, double lo, double hi) { return {{-radius, -radius, lo}, {radius, radius, hi}}; }

Box3d prism_box(const Leaf& leaf, const Profile& profile) {
    Box3d box = profile_box(profile);
    if (box.empty()) return box;
    box.include(Box3d{box.lo * leaf.a, box.hi * leaf.a});
    box.lo.z = 0, box.hi.z = 1;
    return box;
}

Box3d revolution_box(const Profile& profile) {
    const Box3d flat = profile_box(profile);
    return flat.empty() ? flat : around_z(flat.hi.x, flat.lo.y, flat.hi.y);
}

Box3d node_box(const SolidNode& node, const SolidTree& solids, const std::vector<Box3d>& boxes) {
    Box3d box;
    for (std::uint32_t i = 0; i < node.count; ++i) {
        const Box3d& child = boxes[solids.children[node.first + i]];
        if (node.op == SolidOp::subtract) return child;
        if (node.op == SolidOp::unite || i == 0)
            box.include(child);
        else
            box = box.intersection(child);
    }
    return box.empty() ? Box3d{} : box;
}

}  // namespace

Box3d local_box(const Leaf& leaf, const SolidTree& solids) {
    switch (leaf.kind) {
        case LeafKind::box:
            return {{0, 0, 0}, {1, 1, 1}};
        case LeafKind::sphere:
            return around_z(1, -1, 1);
        case LeafKind::cone:
            return around_z(std::max(leaf.a, leaf.b), 0, 1);
        case LeafKind::torus:
            return around_z(leaf.a + leaf.b, -leaf.b, leaf.b);
        case LeafKind::half_space:
            return Box3d::everything();
        case LeafKind::prism:
            return prism_box(leaf, *solids.profiles[leaf.data]);
        case LeafKind::revolution:
            return revolution_box(*solids.profiles[leaf.data]);
        case LeafKind::mesh: {
            Box3d box;
            for (const Vec3d& p : solids.meshes[leaf.data]->vertices) box.include(p);
            return box;
        }
        case LeafKind::form:
            return csg::form_box(solids.forms[leaf.data]);
    }
    return {};
}

Box3d world_box(const Leaf& leaf, const SolidTree& solids) {
    const Box3d box = local_box(leaf, solids);
    return box.bounded() ? leaf.to_world.box(box) : box;
}

std::vector<Box3d> node_boxes(const SolidTree& solids) {
    std::vector<Box3d> boxes;
    boxes.reserve(solids.nodes.size());
    for (const SolidNode& node : solids.nodes)
        boxes.push_back(node.op == SolidOp::leaf ? world_box(solids.leaves[node.first], solids)
                                                 : node_box(node, solids, boxes));
    return boxes;
}

}  // namespace cardioid::formats::povray
