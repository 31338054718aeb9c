#include "bench/models.hpp"

#include <cmath>
#include <numbers>
#include <random>

namespace cardioid::bench {
namespace {

constexpr double size = 100;
constexpr View solid_view{{190, 140, 120}, {50, 50, 50}, 40};

/// The same numbers with every standard library, which its own distributions do not promise.
class Random {
public:
    explicit Random(std::uint32_t seed) : engine_(seed) {}
    double operator()(double lo, double hi) { return lo + (hi - lo) * (static_cast<double>(engine_()) * 0x1p-32); }
    Vec3d point(const Vec3d& lo, const Vec3d& hi) {
        const double x = (*this)(lo.x, hi.x), y = (*this)(lo.y, hi.y), z = (*this)(lo.z, hi.z);
        return {x, y, z};
    }
    std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(engine_() % n); }
    /// A turn about an axis and by an angle, both at random.
    Affine turn() {
        const double z = (*this)(-1, 1), phi = (*this)(0, 2 * std::numbers::pi), rho = std::sqrt(1 - z * z);
        const Vec3d a{rho * std::cos(phi), rho * std::sin(phi), z};
        const double angle = (*this)(0, 2 * std::numbers::pi), s = std::sin(angle), c = std::cos(angle);
        Affine m;
        m.row = {Vec3d{c, -s * a.z, s * a.y} + a * (a.x * (1 - c)), Vec3d{s * a.z, c, -s * a.x} + a * (a.y * (1 - c)),
                 Vec3d{-s * a.y, s * a.x, c} + a * (a.z * (1 - c))};
        return m;
    }

private:
    std::mt19937 engine_;
};

Leaf box(const Vec3d& centre, const Vec3d& half) {
    Leaf leaf;
    leaf.to_world = Affine::translation(centre - half) * Affine::scaling(half * 2.0);
    return leaf;
}

Leaf ball(const Vec3d& centre, double r) {
    Leaf leaf;
    leaf.kind = LeafKind::sphere;
    leaf.to_world = Affine::translation(centre) * Affine::scaling({r, r, r});
    return leaf;
}

Leaf cylinder(const Vec3d& centre, double r, double height) {
    Leaf leaf;
    leaf.kind = LeafKind::cone;
    leaf.a = leaf.b = r;
    leaf.to_world = Affine::translation(centre - Vec3d{0, 0, height / 2}) * Affine::scaling({1, 1, height});
    return leaf;
}

Leaf block() { return box(Vec3d{1, 1, 1} * (size / 2), Vec3d{1, 1, 1} * (size / 2)); }

/// The edge of a cube that has its share of `count` in the block.
double cell(std::uint32_t count) { return size / std::cbrt(count); }

/// Balls on one half, boxes and cylinders on a quarter each.
Leaf any_cutter(Random& random, const Vec3d& centre, double r) {
    switch (random.below(4)) {
        case 0:
            return box(centre, random.point(Vec3d{0.5, 0.5, 0.5} * r, Vec3d{1, 1, 1} * r));
        case 1: {
            const double height = random(1, 2) * r;
            return cylinder(centre, random(0.5, 1) * r, height);
        }
        default:
            return ball(centre, r);
    }
}

std::uint32_t part(SolidTree& tree, Random& random, const Vec3d& centre, double r) {
    const Affine place = Affine::translation(centre) * random.turn();
    const auto add = [&](Leaf leaf) {
        leaf.to_world = place * leaf.to_world;
        return tree.add_leaf(leaf);
    };
    const std::uint32_t body = tree.add_node(
        SolidOp::unite, {add(box({0, 0, 0}, {r, 0.6 * r, 0.4 * r})), add(cylinder({0, 0, 0.5 * r}, 0.5 * r, r)),
                         add(ball({0.8 * r, 0, 0}, 0.55 * r))});
    return tree.add_node(SolidOp::subtract,
                         {body, add(cylinder({0, 0, 0}, 0.3 * r, 3 * r)), add(ball({-0.8 * r, 0, 0.3 * r}, 0.4 * r))});
}

/// A tree over a box cut in halves down to single leaves; differences and intersections only between near neighbours,
/// for those of large halves would leave little.
std::uint32_t grow(SolidTree& tree, Random& random, const Box3d& in, std::uint32_t count) {
    if (count == 1) {
        const Vec3d centre = random.point(in.lo, in.hi), half = in.size() * random(0.5, 0.9);
        return tree.add_leaf(random.below(2) ? ball(centre, max_component(half)) : box(centre, half));
    }
    const Vec3d s = in.size();
    const int axis = s.x >= s.y && s.x >= s.z ? 0 : s.y >= s.z ? 1 : 2;
    Box3d low = in, high = in;
    low.hi[axis] = high.lo[axis] = in.lo[axis] + s[axis] * random(0.4, 0.6);
    const std::uint32_t a = grow(tree, random, low, count / 2), b = grow(tree, random, high, count - count / 2);
    const std::uint32_t dice = random.below(6);
    if (count <= 8 && dice < 2) return tree.add_node(SolidOp::intersect, {a, b});
    return tree.add_node(dice < 4 || count > 64 ? SolidOp::unite : SolidOp::subtract, {a, b});
}

}  // namespace

Model swiss_cheese(std::uint32_t count) {
    Model model{"swiss_cheese_" + std::to_string(count), {}, solid_view};
    Random random(1);
    std::vector<std::uint32_t> children{model.solids.add_leaf(block())};
    for (std::uint32_t i = 0; i < count; ++i) {
        const Vec3d centre = random.point({0, 0, 0}, {size, size, size});
        children.push_back(model.solids.add_leaf(ball(centre, cell(count) * random(0.3, 0.6))));
    }
    model.solids.roots = {model.solids.add_node(SolidOp::subtract, children)};
    return model;
}

Model parts(std::uint32_t count) {
    Model model{"parts_" + std::to_string(count), {}, solid_view};
    Random random(2);
    const auto side = static_cast<std::uint32_t>(std::ceil(std::cbrt(count)));
    const double step = size / side;
    for (std::uint32_t i = 0; i < count; ++i) {
        const Vec3d corner = Vec3d(i % side, i / side % side, i / (side * side)) * step;
        const Vec3d centre = corner + random.point(Vec3d{0.4, 0.4, 0.4} * step, Vec3d{0.6, 0.6, 0.6} * step);
        model.solids.roots.push_back(part(model.solids, random, centre, step * random(0.3, 0.5)));
    }
    return model;
}

Model chain(std::uint32_t count) {
    Model model{"chain_" + std::to_string(count), {}, solid_view};
    Random random(3);
    std::uint32_t root = model.solids.add_leaf(block());
    for (std::uint32_t i = 0; i < count; ++i) {
        const Vec3d centre = random.point({0, 0, 0}, {size, size, size});
        const Leaf cutter = any_cutter(random, centre, cell(count) * random(0.3, 0.6));
        root = model.solids.add_node(SolidOp::subtract, {root, model.solids.add_leaf(cutter)});
    }
    model.solids.roots = {root};
    return model;
}

Model ball_union(std::uint32_t count) {
    Model model{"ball_union_" + std::to_string(count), {}, solid_view};
    Random random(4);
    std::vector<std::uint32_t> children;
    for (std::uint32_t i = 0; i < count; ++i) {
        const Vec3d centre = random.point({0, 0, 0}, {size, size, size});
        children.push_back(model.solids.add_leaf(ball(centre, cell(count) * random(0.3, 0.6))));
    }
    model.solids.roots = {model.solids.add_node(SolidOp::unite, children)};
    return model;
}

Model random_tree(std::uint32_t count) {
    Model model{"random_tree_" + std::to_string(count), {}, solid_view};
    Random random(5);
    model.solids.roots = {grow(model.solids, random, {{0, 0, 0}, {size, size, size}}, count)};
    return model;
}

std::vector<Model> all_models() {
    return {parts(200), swiss_cheese(1000), chain(5000), ball_union(10000), random_tree(5000)};
}

TriangleMesh cornell_box() {
    TriangleMesh mesh;
    const auto quad = [&](const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(), {a, b, c, d});
        mesh.triangles.push_back({first, first + 1, first + 2});
        mesh.triangles.push_back({first, first + 2, first + 3});
    };
    const auto blocks = [&](const std::array<Vec3d, 4>& foot, double height) {
        const Vec3d up{0, height, 0};
        quad(foot[0] + up, foot[1] + up, foot[2] + up, foot[3] + up);
        for (std::size_t i = 0; i < 4; ++i) quad(foot[i], foot[i] + up, foot[(i + 1) % 4] + up, foot[(i + 1) % 4]);
    };
    quad({556, 0, 0}, {0, 0, 0}, {0, 0, 559}, {556, 0, 559});
    quad({556, 549, 0}, {556, 549, 559}, {0, 549, 559}, {0, 549, 0});
    quad({556, 0, 559}, {0, 0, 559}, {0, 549, 559}, {556, 549, 559});
    quad({0, 0, 559}, {0, 0, 0}, {0, 549, 0}, {0, 549, 559});
    quad({556, 0, 0}, {556, 0, 559}, {556, 549, 559}, {556, 549, 0});
    quad({343, 548, 227}, {343, 548, 332}, {213, 548, 332}, {213, 548, 227});
    blocks({Vec3d{130, 0, 65}, {82, 0, 225}, {240, 0, 272}, {290, 0, 114}}, 165);
    blocks({Vec3d{423, 0, 247}, {265, 0, 296}, {314, 0, 456}, {472, 0, 406}}, 330);
    return mesh;
}

TriangleMesh bumpy_ball(std::uint32_t rings) {
    TriangleMesh mesh;
    const std::uint32_t sectors = 2 * rings;
    const auto point = [&](std::uint32_t ring, std::uint32_t sector) {
        const double theta = std::numbers::pi * ring / rings, phi = 2 * std::numbers::pi * sector / sectors;
        const double r = 45 + 5 * std::sin(7 * theta) * std::cos(11 * phi) * std::sin(theta);
        return Vec3d{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)} * r;
    };
    mesh.vertices = {point(0, 0)};
    for (std::uint32_t ring = 1; ring < rings; ++ring)
        for (std::uint32_t sector = 0; sector < sectors; ++sector) mesh.vertices.push_back(point(ring, sector));
    mesh.vertices.push_back(point(rings, 0));
    const auto last = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
    const auto index = [&](std::uint32_t ring, std::uint32_t sector) {
        return ring == 0 ? 0 : ring == rings ? last : 1 + (ring - 1) * sectors + sector % sectors;
    };
    for (std::uint32_t ring = 0; ring < rings; ++ring)
        for (std::uint32_t s = 0; s < sectors; ++s) {
            if (ring > 0) mesh.triangles.push_back({index(ring, s), index(ring + 1, s), index(ring, s + 1)});
            if (ring + 1 < rings)
                mesh.triangles.push_back({index(ring, s + 1), index(ring + 1, s), index(ring + 1, s + 1)});
        }
    mesh.closed = true;
    return mesh;
}

}  // namespace cardioid::bench
