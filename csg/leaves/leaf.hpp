#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "rt_core/scene/solid.hpp"

namespace cardioid::csg {

class MeshShape;

/// Where a ray crosses a leaf's surface. A leaf's events along a whole line are sorted and even in number,
/// entering and leaving in turn; t may be infinite.
struct Event {
    double t;
    std::uint32_t leaf;
    std::uint32_t face : 31;
    std::uint32_t entering : 1;
};
inline Event make_event(double t, std::uint32_t leaf, std::uint32_t face, bool entering) {
    return {t, leaf, face & 0x7FFFFFFFU, entering ? 1U : 0U};
}

/// How a leaf is solved; more kinds than a scene has, because common cases have quicker solvers. The convex ones first.
enum class Solver : std::uint8_t {
    ball,
    ellipsoid,
    axis_box,
    box,
    cone,
    half_space,
    convex,
    torus,
    prism,
    revolution,
    form,
    mesh
};
constexpr bool is_convex(Solver solver) { return solver <= Solver::convex; }

/// n.p <= d is inside.
struct Plane {
    Vec3d n;
    double d;
};

/// What leaves of one shape share: profiles, planes, meshes.
struct Shape {
    std::shared_ptr<const Profile> profile;
    std::vector<Plane> planes;
    std::shared_ptr<const MeshShape> mesh;
    Form form{};
    [[nodiscard]] std::size_t memory_bytes() const noexcept;
};

/// A leaf ready to be met by rays: 128 bytes, those that a ball needs in front.
struct SolvedLeaf {
    Vec3d t;  ///< ball: its centre; axis_box: its low corner; else the translation of the map world -> local
    double a = 0, b = 0;  ///< ball: radius in a; else as Leaf
    const Shape* shape = nullptr;
    std::uint32_t material = 0;
    Solver solver = Solver::ball;
    std::array<Vec3d, 3> row{};  ///< axis_box: high corner in row[0]; else the linear part of the map world -> local

    [[nodiscard]] Vec3d vector(Vec3d v) const { return {dot(row[0], v), dot(row[1], v), dot(row[2], v)}; }
    [[nodiscard]] Vec3d point(Vec3d p) const { return vector(p) + t; }
    [[nodiscard]] Vec3d transposed_vector(Vec3d v) const { return row[0] * v.x + row[1] * v.y + row[2] * v.z; }
};
static_assert(sizeof(SolvedLeaf) == 128);

using EventList = std::vector<Event>;

/// Appends the events of the line o + t d with leaf number `index`: an even number, sorted by t.
/// All of the line counts, also t < 0.
void append_events(const SolvedLeaf& leaf, std::uint32_t index, Vec3d o, Vec3d d, EventList& out);

/// Unit normal, out of the leaf, of `face` at the world point p on it; turned_normal() where the leaf has a map.
Vec3d turned_normal(const SolvedLeaf& leaf, std::uint32_t face, Vec3d p);
inline Vec3d normal(const SolvedLeaf& leaf, std::uint32_t face, Vec3d p) {
    if (leaf.solver == Solver::ball) return normalize(p - leaf.t);
    if (leaf.solver != Solver::axis_box) return turned_normal(leaf, face, p);
    const double side = face % 2 ? 1 : -1;
    return {face / 2 == 0 ? side : 0, face / 2 == 1 ? side : 0, face / 2 == 2 ? side : 0};
}

/// The leaf with the quickest solver; `shape` must outlive it, null for kinds that need none. Its determinant is not
/// zero.
SolvedLeaf solve(const Leaf& leaf, const Shape* shape);

/// Makes the shapes of a tree's leaves, each profile and mesh once.
class ShapeMaker {
public:
    explicit ShapeMaker(const SolidTree& tree);
    /// Null for kinds that need none.
    [[nodiscard]] std::shared_ptr<const Shape> shape_of(const Leaf& leaf);

private:
    const SolidTree& tree_;
    std::vector<std::shared_ptr<const Shape>> prisms_, revolutions_, meshes_, forms_;
};

/// Box around a leaf in the world; infinite for a half space.
Box3d leaf_bounds(const SolidTree& tree, const Leaf& leaf);

}  // namespace cardioid::csg
