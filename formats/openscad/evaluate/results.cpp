#include "formats/openscad/evaluate/results.hpp"

#include <iterator>

#include "formats/openscad/geometry/transforms.hpp"

namespace cardioid::formats::openscad {

void Results::drop(const ResultMark& since) {
    solids_.resize(since.solid);
    planes_.resize(since.plane);
}

std::vector<std::uint32_t> Results::take_solids(const ResultMark& since) {
    std::vector<std::uint32_t> out(solids_.begin() + static_cast<std::ptrdiff_t>(since.solid), solids_.end());
    solids_.resize(since.solid);
    return out;
}

std::vector<Plane> Results::take_planes(const ResultMark& since) {
    const auto first = planes_.begin() + static_cast<std::ptrdiff_t>(since.plane);
    std::vector<Plane> out(std::make_move_iterator(first), std::make_move_iterator(planes_.end()));
    planes_.resize(since.plane);
    return out;
}

void Results::add_leaf(const Leaf& leaf) {
    solids_.push_back(shapes_.solids.add_leaf(leaf));
    material_of_node_.push_back(leaf.material);
}

bool Results::place(const Shape& shape, const Affine& to_world, std::uint32_t material, const Origin& origin) {
    const Affine whole = to_world * shape.local;
    const bool singular = is_singular(whole);
    if (singular || is_out_of_reach(whole)) {
        shapes_.warnings.add(origin.where, singular ? "a solid is scaled by 0 or by what is not finite: removed"
                                                    : "a solid is larger than 1e15 or farther out: removed");
        return false;
    }
    add_leaf({shape.kind, whole, shape.a, shape.b, shape.data, material, origin.line});
    return true;
}

void Results::join(const ResultMark& since) {
    if (solids_.size() > since.solid + 1) combine_solids(SolidOp::unite, since.solid);
    if (has_planes(since)) add_plane(unite(take_planes(since), shapes_));
}

void Results::combine(SolidOp op, const ResultMark& since) {
    if (solids_.size() > since.solid + 1) combine_solids(op, since.solid);
    if (planes_.size() <= since.plane + 1) return;
    const std::vector<Plane> parts = take_planes(since);
    Plane result = op == SolidOp::subtract ? subtract(parts, shapes_) : intersect(parts, shapes_);
    if (!result.profile.empty()) add_plane(std::move(result));
}

void Results::combine_solids(SolidOp op, std::size_t first) {
    const std::vector<std::uint32_t> parts = take_solids({first, planes_.size()});
    solids_.push_back(shapes_.solids.add_node(op, parts));
    material_of_node_.push_back(material_of_node_[parts[0]]);
}

}  // namespace cardioid::formats::openscad
