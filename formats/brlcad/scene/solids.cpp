#include "formats/brlcad/scene/solids.hpp"

#include <algorithm>
#include <cmath>

namespace cardioid::formats::brlcad {

namespace {

/// Ratios that differ by less are meant to be the same: databases of version 4 hold single precision.
constexpr double same_ratio = 1e-5;

/// Beyond these a superell is a box, or too thin for its corners to be told apart in double precision.
constexpr double least_exponent = 0.01, most_exponent = 20;

using Node = std::optional<std::uint32_t>;

class Numbers {
public:
    explicit Numbers(const Solid& solid) : v_(solid.numbers) {}
    [[nodiscard]] Vec3d vector(std::size_t i) const { return {v_[i], v_[i + 1], v_[i + 2]}; }
    double operator[](std::size_t i) const { return v_[i]; }

private:
    const std::vector<double>& v_;
};

Vec3d unit(Vec3d v) {
    const double size = length(v);
    return size > 0 ? v * (1 / size) : Vec3d{};
}

Node no_volume(SolidTarget& target) {
    target.note = "has no volume";
    return std::nullopt;
}

Node add_form(SolidTarget& target, FormKind kind, std::array<double, 4> numbers, const Affine& map) {
    return add_leaf(target, {.kind = LeafKind::form, .to_world = map, .data = target.tree.add_form({kind, numbers})});
}

Node add_tgc(SolidTarget& target, const Numbers& n) {
    Vec3d v = n.vector(0), h = n.vector(3), a = n.vector(6), b = n.vector(9), c = n.vector(12), d = n.vector(15);
    if (dot(a, a) * dot(b, b) < dot(c, c) * dot(d, d)) {  // the larger end is the base: its axes are the columns
        v += h, h = -h;
        std::swap(a, c), std::swap(b, d);
    }
    if (!(dot(a, a) > 0 && dot(b, b) > 0)) return no_volume(target);
    const double p = dot(c, a) / dot(a, a), q = dot(d, b) / dot(b, b);
    const Affine map = columns(a, b, h, v);
    if (p < -same_ratio || q < -same_ratio || length(cross(a, c)) > 1e-3 * length(a) * length(c)) {
        target.note = "has ends whose axes are not parallel, and is left out";
        return std::nullopt;
    }
    if (std::abs(p - q) <= same_ratio)
        return add_leaf(target, {.kind = LeafKind::cone,
                                 .to_world = map,
                                 .a = 1,
                                 .b = std::abs(p) <= same_ratio       ? 0
                                      : std::abs(p - 1) <= same_ratio ? 1
                                                                      : p});
    return add_form(target, FormKind::taper, {std::max(p, 0.0), std::max(q, 0.0)}, map);
}

/// The hull of two balls: BRL-CAD's cone touches both.
Node add_particle(SolidTarget& target, const Numbers& n) {
    const Vec3d v = n.vector(0), h = n.vector(3);
    const double rv = n[6], rh = n[7], height = length(h);
    const auto ball = [&](Vec3d centre, double r) {
        return add_leaf(
            target, {.kind = LeafKind::sphere, .to_world = Affine::translation(centre) * Affine::scaling({r, r, r})});
    };
    if (!(rv > 0 || rh > 0)) return no_volume(target);
    if (height <= std::abs(rv - rh)) return rv >= rh ? ball(v, rv) : ball(v + h, rh);
    const double sine = (rv - rh) / height, cosine = std::sqrt(1 - sine * sine);
    const Vec3d axis = unit(h), from = v + axis * (rv * sine), to = v + h + axis * (rh * sine);
    Affine map = upright(axis, from);
    for (Vec3d& row : map.row) row.z *= length(to - from);
    std::vector<std::uint32_t> parts;
    for (const Node& part :
         {add_leaf(target, {.kind = LeafKind::cone, .to_world = map, .a = rv * cosine, .b = rh * cosine}),
          rv > 0 ? ball(v, rv) : Node{}, rh > 0 ? ball(v + h, rh) : Node{}})
        if (part) parts.push_back(*part);
    return target.tree.add_node(SolidOp::unite, parts);
}

/// The share of u^2 in a hyperbola's section, its asymptotes crossing c beyond the top of something of height h.
double hyperbolic(double c, double h) { return c >= 0 && h > 0 ? 1 / (1 + 2 * c / h) : 0; }

Node add_bowl(SolidTarget& target, const Numbers& n, double c) {
    const Vec3d h = n.vector(3), a = unit(n.vector(6)), b = unit(cross(h, a));
    const double w = c < 0 ? 0 : std::min(hyperbolic(c, length(h)), 1 - same_ratio);
    return add_form(target, FormKind::bowl, {w}, columns(a * n[9], b * n[10], h, n.vector(0)));
}

Node add_trough(SolidTarget& target, const Numbers& n, double c) {
    const Vec3d h = n.vector(3), b = n.vector(6), across = unit(cross(h, b)) * n[9];
    const double w = c < 0 ? 0 : std::min(hyperbolic(c, length(b)), 1 - same_ratio);
    return add_form(target, FormKind::trough, {w}, columns(across, h, b, n.vector(0)));
}

Node add_eto(SolidTarget& target, const Numbers& n) {
    const double r = n[9];
    if (!(r > 0 && n[10] > 0)) return no_volume(target);
    const Vec3d axis = unit(n.vector(3)), c = n.vector(6) * (1 / r);
    const double size = length(c), d = n[10] / r;
    if (!(size > 0)) return no_volume(target);
    const double up = dot(c, axis) / size, out = std::sqrt(std::max(0.0, 1 - up * up));
    const double cc = 1 / (size * size), dd = 1 / (d * d);
    const double A = out * out * cc + up * up * dd, B = 2 * out * up * (cc - dd), C = up * up * cc + out * out * dd;
    if (C / (A * C - B * B / 4) >= 1) {
        target.note = "reaches over its own axis, and is left out";
        return std::nullopt;
    }
    Affine map = upright(axis, n.vector(0));
    for (Vec3d& row : map.row) row *= r;
    return add_form(target, FormKind::tilted_ring, {1, A, B, C}, map);
}

Node add_hyp(SolidTarget& target, const Numbers& n) {
    const Vec3d h = n.vector(3) * 0.5, a = n.vector(6), b = unit(cross(h, a)) * n[9];
    const double neck = n[10] * n[10];
    const Affine map = columns(a, b, h, n.vector(0) + h);
    if (neck >= 1 - same_ratio)
        return add_leaf(target, {.kind = LeafKind::cone,
                                 .to_world = map * Affine::translation({0, 0, -1}) * Affine::scaling({1, 1, 2}),
                                 .a = 1,
                                 .b = 1});
    return add_form(target, FormKind::waist, {std::max(neck, same_ratio)}, map);
}

/// A line with a radius: a cylinder, or a tube where it has a thickness.
Node add_cline(SolidTarget& target, const Numbers& n) {
    const double thickness = n[0], radius = n[1];
    const Vec3d v = n.vector(2), h = n.vector(5);
    const auto cylinder = [&](double r) {
        Affine map = upright(h, v);
        for (Vec3d& row : map.row) row.z *= length(h);
        return add_leaf(target, {.kind = LeafKind::cone, .to_world = map, .a = r, .b = r});
    };
    if (!(radius > 0)) return no_volume(target);
    const Node whole = cylinder(radius);
    if (!whole || !(thickness > 0 && thickness < radius)) return whole;
    return target.tree.add_node(SolidOp::subtract, {*whole, *cylinder(radius - thickness)});
}

Node add_superell(SolidTarget& target, const Numbers& n) {
    const double power = n[12], around = n[13];
    if (!(power >= least_exponent && power <= most_exponent && around >= least_exponent && around <= most_exponent)) {
        target.note = "has an exponent outside of 0.01 to 20, and is left out";
        return std::nullopt;
    }
    return add_form(target, FormKind::superellipsoid, {power, around},
                    columns(n.vector(3), n.vector(6), n.vector(9), n.vector(0)));
}

Node add_simple(SolidTarget& target, const Solid& solid) {
    const Numbers n(solid);
    switch (solid.kind) {
        case SolidKind::tgc:
            return add_tgc(target, n);
        case SolidKind::ell:
            return add_leaf(target, {.kind = LeafKind::sphere,
                                     .to_world = columns(n.vector(3), n.vector(6), n.vector(9), n.vector(0))});
        case SolidKind::tor:
            if (!(n[7] > 0 && n[7] < n[6])) return no_volume(target);
            return add_leaf(
                target, {.kind = LeafKind::torus, .to_world = upright(n.vector(3), n.vector(0)), .a = n[6], .b = n[7]});
        case SolidKind::half: {
            const Vec3d normal = n.vector(0);
            if (!(dot(normal, normal) > 0)) return no_volume(target);
            return add_leaf(target, {.kind = LeafKind::half_space,
                                     .to_world = upright(normal, normal * (n[3] / dot(normal, normal)))});
        }
        case SolidKind::part:
            return add_particle(target, n);
        case SolidKind::rpc:
            return add_trough(target, n, -1);
        case SolidKind::rhc:
            return add_trough(target, n, n[10]);
        case SolidKind::epa:
            return add_bowl(target, n, -1);
        case SolidKind::ehy:
            return add_bowl(target, n, n[11]);
        case SolidKind::eto:
            return add_eto(target, n);
        case SolidKind::hyp:
            return add_hyp(target, n);
        case SolidKind::cline:
            return add_cline(target, n);
        default:
            return add_superell(target, n);
    }
}

}  // namespace

Affine columns(Vec3d x, Vec3d y, Vec3d z, Vec3d t) {
    return {{Vec3d{x.x, y.x, z.x}, {x.y, y.y, z.y}, {x.z, y.z, z.z}}, t};
}

Affine upright(Vec3d axis, Vec3d t) {
    const Vec3d z = unit(axis);
    const Vec3d aside = std::abs(z.x) < 0.6 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
    const Vec3d x = unit(cross(aside, z));
    return columns(x, cross(z, x), z, t);
}

std::optional<std::uint32_t> add_leaf(SolidTarget& target, Leaf leaf) {
    leaf.to_world = target.place * leaf.to_world;
    leaf.material = target.material;
    const double size =
        length(leaf.to_world.column(0)) * length(leaf.to_world.column(1)) * length(leaf.to_world.column(2));
    const double determinant = std::abs(leaf.to_world.determinant());
    if (!std::isfinite(determinant) || !is_finite(leaf.to_world.t) || !(determinant > 1e-12 * size))
        return no_volume(target);
    return target.tree.add_leaf(leaf);
}

std::optional<std::uint32_t> add_solid(SolidTarget& target, const Solid& solid) {
    target.note.clear();
    for (const double x : solid.numbers)
        if (!std::isfinite(x) || std::abs(x) > 1e15) {
            target.note = "has a number that is not finite or beyond 1e15";
            return std::nullopt;
        }
    switch (solid.kind) {
        case SolidKind::arb8:
            return add_arb8(target, solid);
        case SolidKind::arbn:
            return add_arbn(target, solid);
        case SolidKind::bot:
            return add_bot(target, solid);
        case SolidKind::pipe:
            return add_pipe(target, solid);
        case SolidKind::extrude:
            return add_extrude(target, solid);
        case SolidKind::revolve:
            return add_revolve(target, solid);
        case SolidKind::ars:
            return add_ars(target, solid);
        case SolidKind::dsp:
        case SolidKind::ebm:
        case SolidKind::vol:
        case SolidKind::hf:
            return add_grid(target, solid);
        case SolidKind::metaball:
            return add_metaball(target, solid);
        case SolidKind::sketch:  // others extrude or turn it
        case SolidKind::data:    // others are made of it
            return std::nullopt;
        case SolidKind::nothing:
            target.note = "is of type \"" + solid.type + "\", of which nothing is drawn";
            return std::nullopt;
        case SolidKind::unsupported:
            target.note = "is of type \"" + solid.type + "\", which is not supported, and is left out";
            return std::nullopt;
        default:
            return add_simple(target, solid);
    }
}

}  // namespace cardioid::formats::brlcad
