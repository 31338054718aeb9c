#pragma once
#include <random>
#include <vector>

#include "csg/compile.hpp"
#include "csg/region/solid_region.hpp"

namespace cardioid::csg::test {

inline Leaf box_leaf(Vec3d lo, Vec3d size) {
    Leaf leaf;
    leaf.kind = LeafKind::box;
    leaf.to_world = Affine::translation(lo) * Affine::scaling(size);
    return leaf;
}
inline Leaf ball_leaf(Vec3d centre, double r) {
    Leaf leaf;
    leaf.kind = LeafKind::sphere;
    leaf.to_world = Affine::translation(centre) * Affine::scaling({r, r, r});
    return leaf;
}
inline Leaf cone_leaf(Vec3d base, double a, double b, double h) {
    Leaf leaf;
    leaf.kind = LeafKind::cone;
    leaf.a = a, leaf.b = b;
    leaf.to_world = Affine::translation(base) * Affine::scaling({1, 1, h});
    return leaf;
}
inline Leaf torus_leaf(Vec3d centre, double R, double r) {
    Leaf leaf;
    leaf.kind = LeafKind::torus;
    leaf.a = R, leaf.b = r;
    leaf.to_world = Affine::translation(centre);
    return leaf;
}

/// Fixed seeds, so that a failure can be run again.
class Random {
public:
    explicit Random(unsigned seed) : engine_(seed) {}
    double operator()(double lo, double hi) { return std::uniform_real_distribution<double>(lo, hi)(engine_); }
    int whole(int lo, int hi) { return std::uniform_int_distribution<int>(lo, hi)(engine_); }
    Vec3d point(double lo, double hi) { return {(*this)(lo, hi), (*this)(lo, hi), (*this)(lo, hi)}; }
    Vec3d direction() {
        for (;;) {
            const Vec3d v = point(-1, 1);
            if (dot(v, v) < 1 && dot(v, v) > 1e-3) return normalize(v);
        }
    }

private:
    std::mt19937 engine_;
};

/// A random tree of depth at most `depth` over leaves made by `leaf`; returns its root node.
template <class MakeLeaf>
std::uint32_t random_tree(SolidTree& tree, Random& random, int depth, const MakeLeaf& leaf) {
    if (depth == 0 || random.whole(0, 4) == 0) return tree.add_leaf(leaf());
    std::vector<std::uint32_t> children;
    for (int i = random.whole(2, 3); i > 0; --i) children.push_back(random_tree(tree, random, depth - 1, leaf));
    const SolidOp ops[] = {SolidOp::unite, SolidOp::unite, SolidOp::intersect, SolidOp::subtract};
    return tree.add_node(ops[random.whole(0, 3)], children);
}

/// A leaf of any analytic kind, turned at random, near the middle of [0, 10]^3.
inline Leaf random_leaf(Random& random) {
    Leaf leaf;
    const int kind = random.whole(0, 3);
    const Vec3d c = random.point(2, 8);
    const double r = random(1, 4);
    leaf = kind == 0   ? box_leaf(c - Vec3d{r, r, r} * 0.5, {r, r, r})
           : kind == 1 ? ball_leaf(c, r * 0.6)
           : kind == 2 ? cone_leaf(c, r * 0.5, random.whole(0, 1) ? r * 0.5 : r * 0.2, r)
                       : torus_leaf(c, r * 0.6, r * 0.2);
    const Frame frame(normalize(Vec3(random.direction())));
    Affine turn;
    turn.row = {Vec3d(frame.s), Vec3d(frame.t), Vec3d(frame.n)};
    leaf.to_world = Affine::translation(c) * turn * Affine::translation(-c) * leaf.to_world;
    return leaf;
}

/// All nodes' values for given leaf states, straight from the definition of the operations.
inline bool evaluate(const SolidTree& tree, const std::vector<char>& inside) {
    std::vector<char> value(tree.nodes.size());
    for (std::size_t n = 0; n < tree.nodes.size(); ++n) {
        const SolidNode& node = tree.nodes[n];
        const auto child = [&](std::uint32_t i) { return value[tree.children[node.first + i]] != 0; };
        bool v = node.op == SolidOp::intersect && node.count > 0;
        if (node.op == SolidOp::leaf) v = inside[node.first] != 0;
        if (node.op == SolidOp::subtract && node.count > 0) v = child(0);
        for (std::uint32_t i = 0; node.op != SolidOp::leaf && i < node.count; ++i) {
            if (node.op == SolidOp::unite) v = v || child(i);
            if (node.op == SolidOp::intersect) v = v && child(i);
            if (node.op == SolidOp::subtract && i > 0) v = v && !child(i);
        }
        value[n] = v;
    }
    return std::any_of(tree.roots.begin(), tree.roots.end(), [&](std::uint32_t r) { return value[r] != 0; });
}

/// Changes of the model along the ray in (0, t_max): every leaf's events, sorted, the tree evaluated after each.
inline std::vector<double> reference_boundaries(const SolidTree& tree, const Ray& ray) {
    EventList events;
    ShapeMaker shapes(tree);
    for (std::uint32_t i = 0; i < tree.leaves.size(); ++i) {
        const auto shape = shapes.shape_of(tree.leaves[i]);
        append_events(solve(tree.leaves[i], shape.get()), i, ray.o, ray.d, events);
    }
    std::stable_sort(events.begin(), events.end(), [](const Event& a, const Event& b) { return a.t < b.t; });
    std::vector<char> inside(tree.leaves.size(), 0);
    std::vector<double> out;
    bool was = evaluate(tree, inside);
    for (const Event& e : events) {
        inside[e.leaf] = static_cast<char>(e.entering);
        const bool is = evaluate(tree, inside);
        if (is != was && e.t > 0 && e.t < ray.t_max) out.push_back(e.t);
        was = is;
    }
    return out;
}

inline std::unique_ptr<SolidRegion> whole(const SolidTree& tree, bool six_digits) {
    auto region = compile_whole(tree, six_digits);
    return std::unique_ptr<SolidRegion>(static_cast<SolidRegion*>(region.release()));
}

}  // namespace cardioid::csg::test
