#pragma once
#include <string>
#include <vector>

#include "rt_core/scene/solid.hpp"

namespace cardioid::bench {

/// A pinhole camera over a square picture, z up.
struct View {
    Vec3d eye, target;
    double fov_deg = 40;
};

/// A model of the benchmarks: about 100 units across, the same on every machine.
struct Model {
    std::string name;
    SolidTree solids;
    View view;
};

/// A cube less `count` balls at random places; together they take about a third of it, whatever their number.
Model swiss_cheese(std::uint32_t count);
/// `count` parts turned at random: each a box, a cylinder and a ball less a cylinder and a ball.
Model parts(std::uint32_t count);
/// (((cube - a) - b) - c) ..., `count` differences deep; cutters are balls, boxes and cylinders.
Model chain(std::uint32_t count);
/// The union of `count` balls.
Model ball_union(std::uint32_t count);
/// Unions, differences and intersections at random over `count` balls and boxes, each operation between neighbours.
Model random_tree(std::uint32_t count);
/// Every model of the comparison with other programs.
std::vector<Model> all_models();

/// A Cornell box of 32 triangles: five walls, a lamp and two blocks without bottoms.
TriangleMesh cornell_box();
inline constexpr View cornell_view{{278, 273, -800}, {278, 273, 0}, 39};
/// A closed ball of radius about 50 with bumps, of 2 * rings * (2 * rings - 2) triangles; rings >= 2.
TriangleMesh bumpy_ball(std::uint32_t rings);
inline constexpr View ball_view{{130, 100, 80}, {0, 0, 0}, 40};

}  // namespace cardioid::bench
