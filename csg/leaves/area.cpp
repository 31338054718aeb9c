#include "csg/leaves/area.hpp"

#include <numbers>

namespace cardioid::csg {
namespace {

constexpr double pi_d = std::numbers::pi;
/// Matrices of .csg files have six digits.
constexpr double slack = 1e-5;

bool equal(double a, double b) { return std::abs(a - b) <= slack * (a + b); }
bool square(Vec3d a, Vec3d b) { return std::abs(dot(a, b)) <= slack * length(a) * length(b); }

double box_area(Vec3d x, Vec3d y, Vec3d z) {
    return 2 * (length(cross(x, y)) + length(cross(y, z)) + length(cross(z, x)));
}

}  // namespace

double leaf_area(const SolvedLeaf& leaf) noexcept {
    if (leaf.solver == Solver::ball) return 4 * pi_d * leaf.a * leaf.a;
    if (leaf.solver == Solver::axis_box) {
        const Vec3d size = leaf.row[0] - leaf.t;
        return box_area({size.x, 0, 0}, {0, size.y, 0}, {0, 0, size.z});
    }
    if (leaf.solver != Solver::box && leaf.solver != Solver::cone && leaf.solver != Solver::torus) return 0;
    const Affine to_world = Affine{leaf.row, leaf.t}.inverse();
    const Vec3d x = to_world.column(0), y = to_world.column(1), z = to_world.column(2);
    if (leaf.solver == Solver::box) return box_area(x, y, z);
    const double scale = length(x), height = length(z);
    if (!equal(scale, length(y)) || !square(x, y) || !square(y, z) || !square(z, x)) return 0;
    if (leaf.solver == Solver::torus)
        return equal(scale, height) ? 4 * pi_d * pi_d * leaf.a * leaf.b * scale * scale : 0;
    const double r0 = leaf.a * scale, r1 = leaf.b * scale;
    return pi_d * (r0 * r0 + r1 * r1 + (r0 + r1) * std::hypot(height, r0 - r1));
}

}  // namespace cardioid::csg
