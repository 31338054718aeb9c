#include "csg/leaves/leaf.hpp"

#include <algorithm>
#include <cmath>

#include "csg/leaves/convex_planes.hpp"
#include "csg/leaves/forms.hpp"
#include "csg/leaves/mesh_shape.hpp"
#include "csg/leaves/solvers.hpp"

namespace cardioid::csg {
namespace {

/// Prisms and meshes with more faces than this are not met as planes.
constexpr std::size_t most_planes = 64;

void append(const Span& span, std::uint32_t index, EventList& out) {
    if (span.empty()) return;
    out.push_back(make_event(span.t0, index, span.face0, true));
    out.push_back(make_event(span.t1, index, span.face1, false));
}

void append_torus(const SolvedLeaf& leaf, std::uint32_t index, Vec3d o, Vec3d d, EventList& out) {
    std::array<double, 4> roots;
    const int count = torus_roots(leaf.a, leaf.b, o, d, roots);
    for (int i = 0; i < count; ++i) out.push_back(make_event(roots[static_cast<std::size_t>(i)], index, 0, i % 2 == 0));
}

/// In local space, of any length.
Vec3d local_normal(const SolvedLeaf& leaf, std::uint32_t face, Vec3d p) {
    switch (leaf.solver) {
        case Solver::ellipsoid:
            return p;
        case Solver::box: {
            Vec3d n;
            n[static_cast<int>(face / 2)] = face % 2 ? 1 : -1;
            return n;
        }
        case Solver::cone: {
            if (face != 0) return {0, 0, face == 2 ? 1.0 : -1.0};
            const double rho = std::sqrt(p.x * p.x + p.y * p.y);
            return {p.x, p.y, (leaf.a - leaf.b) * rho};
        }
        case Solver::torus: {
            const double rho = std::sqrt(p.x * p.x + p.y * p.y);
            const double share = rho > 0 ? 1 - leaf.a / rho : 1;
            return {p.x * share, p.y * share, p.z};
        }
        case Solver::half_space:
            return {0, 0, 1};
        case Solver::convex:
            return leaf.shape->planes[face].n;
        case Solver::prism:
            return prism_normal(leaf, face);
        case Solver::revolution:
            return revolution_normal(leaf, face, p);
        case Solver::form:
            return form_normal(leaf.shape->form, face, p);
        case Solver::mesh:
            return leaf.shape->mesh->normal(face);
        case Solver::ball:
        case Solver::axis_box:
            break;
    }
    return {0, 0, 1};
}

/// Whether m maps axes to axes: a scaling, perhaps with quarter turns.
bool keeps_axes(const Affine& m) {
    const auto one = [](const Vec3d& row) { return (row.x != 0) + (row.y != 0) + (row.z != 0) == 1; };
    return one(m.row[0]) && one(m.row[1]) && one(m.row[2]);
}

/// The radius where m scales all directions alike, else 0.
double uniform_scale(const Affine& m) {
    const Vec3d x = m.column(0), y = m.column(1), z = m.column(2);
    const double r = length(x), slack = 1e-14 * r * r;
    const bool round = std::abs(dot(y, y) - r * r) <= slack && std::abs(dot(z, z) - r * r) <= slack &&
                       std::abs(dot(x, y)) <= slack && std::abs(dot(y, z)) <= slack && std::abs(dot(z, x)) <= slack;
    return round ? r : 0;
}

Solver general_solver(LeafKind kind) {
    switch (kind) {
        case LeafKind::box:
            return Solver::box;
        case LeafKind::sphere:
            return Solver::ellipsoid;
        case LeafKind::cone:
            return Solver::cone;
        case LeafKind::torus:
            return Solver::torus;
        case LeafKind::half_space:
            return Solver::half_space;
        case LeafKind::prism:
            return Solver::prism;
        case LeafKind::revolution:
            return Solver::revolution;
        case LeafKind::form:
            return Solver::form;
        case LeafKind::mesh:
            break;
    }
    return Solver::mesh;
}

Box3d local_bounds(const SolidTree& tree, const Leaf& leaf) {
    switch (leaf.kind) {
        case LeafKind::box:
            return {{0, 0, 0}, {1, 1, 1}};
        case LeafKind::sphere:
            return {{-1, -1, -1}, {1, 1, 1}};
        case LeafKind::cone: {
            const double r = std::max(leaf.a, leaf.b);
            return {{-r, -r, 0}, {r, r, 1}};
        }
        case LeafKind::torus:
            return {{-leaf.a - leaf.b, -leaf.a - leaf.b, -leaf.b}, {leaf.a + leaf.b, leaf.a + leaf.b, leaf.b}};
        case LeafKind::half_space:
            return Box3d::everything();
        case LeafKind::prism:
        case LeafKind::revolution: {
            Box3d box;
            for (const auto& contour : tree.profiles[leaf.data]->contours)
                for (const Vec2d p : contour) {
                    if (leaf.kind == LeafKind::prism) {
                        box.include({p.x, p.y, 0}), box.include({p.x * leaf.a, p.y * leaf.a, 1});
                    } else {
                        box.include({-p.x, -p.x, p.y}), box.include({p.x, p.x, p.y});
                    }
                }
            return box;
        }
        case LeafKind::form:
            return form_box(tree.forms[leaf.data]);
        case LeafKind::mesh:
            break;
    }
    Box3d box;
    for (const Vec3d& v : tree.meshes[leaf.data]->vertices) box.include(v);
    return box;
}

/// Half the extent of the image of a disc or ball of the unit size under m, axis by axis.
Box3d sphere_bounds(const Affine& m) {
    const Vec3d half{length(m.row[0]), length(m.row[1]), length(m.row[2])};
    return {m.t - half, m.t + half};
}

Box3d cone_bounds(const Affine& m, double a, double b) {
    Box3d box;
    for (const double z : {0.0, 1.0}) {
        const double r = z == 0 ? a : b;
        const Vec3d centre = m.point({0, 0, z});
        const Vec3d half{r * std::hypot(m.row[0].x, m.row[0].y), r * std::hypot(m.row[1].x, m.row[1].y),
                         r * std::hypot(m.row[2].x, m.row[2].y)};
        box.include(Box3d{centre - half, centre + half});
    }
    return box;
}

}  // namespace

std::size_t Shape::memory_bytes() const noexcept {
    std::size_t bytes = sizeof(*this) + planes.capacity() * sizeof(Plane) + (mesh ? mesh->memory_bytes() : 0);
    if (profile)
        for (const auto& contour : profile->contours) bytes += contour.capacity() * sizeof(Vec2d);
    return bytes;
}

Span convex_leaf_span(const SolvedLeaf& leaf, Vec3d o, Vec3d d) {
    if (leaf.solver == Solver::ball) return ball_span(leaf.t, leaf.a, o, d);
    if (leaf.solver == Solver::axis_box) return axis_box_span(leaf.t, leaf.row[0], o, d);
    const Vec3d lo = leaf.point(o), ld = leaf.vector(d);
    switch (leaf.solver) {
        case Solver::ellipsoid:
            return unit_sphere_span(lo, ld);
        case Solver::box:
            return axis_box_span({0, 0, 0}, {1, 1, 1}, lo, ld);
        case Solver::cone:
            return cone_span(leaf.a, leaf.b, lo, ld);
        case Solver::half_space:
            return half_space_span(lo, ld);
        default:
            return convex_span(leaf.shape->planes, lo, ld);
    }
}

void append_events(const SolvedLeaf& leaf, std::uint32_t index, Vec3d o, Vec3d d, EventList& out) {
    if (is_convex(leaf.solver)) return append(convex_leaf_span(leaf, o, d), index, out);
    const Vec3d lo = leaf.point(o), ld = leaf.vector(d);
    switch (leaf.solver) {
        case Solver::torus:
            return append_torus(leaf, index, lo, ld, out);
        case Solver::prism:
            return append_prism(leaf, index, lo, ld, out);
        case Solver::revolution:
            return append_revolution(leaf, index, lo, ld, out);
        case Solver::form:
            return append_form(leaf.shape->form, index, lo, ld, out);
        default:
            return leaf.shape->mesh->append_events(index, lo, ld, out);
    }
}

Vec3d turned_normal(const SolvedLeaf& leaf, std::uint32_t face, Vec3d p) {
    const Vec3d n = leaf.transposed_vector(local_normal(leaf, face, leaf.point(p)));
    const double size = length(n);
    return size > 0 ? n * (1 / size) : Vec3d{0, 0, 1};
}

ShapeMaker::ShapeMaker(const SolidTree& tree)
    : tree_(tree),
      prisms_(tree.profiles.size()),
      revolutions_(tree.profiles.size()),
      meshes_(tree.meshes.size()),
      forms_(tree.forms.size()) {}

std::shared_ptr<const Shape> ShapeMaker::shape_of(const Leaf& leaf) {
    const auto kept = [](std::shared_ptr<const Shape>& place, auto make) {
        if (!place) place = std::make_shared<const Shape>(make());
        return place;
    };
    switch (leaf.kind) {
        case LeafKind::mesh:
            return kept(meshes_[leaf.data], [&] {
                std::vector<Plane> planes = convex_planes(*tree_.meshes[leaf.data], most_planes);
                if (!planes.empty()) return Shape{nullptr, std::move(planes), nullptr};
                return Shape{nullptr, {}, std::make_shared<const MeshShape>(tree_.meshes[leaf.data])};
            });
        case LeafKind::form:
            return kept(forms_[leaf.data], [&] { return Shape{nullptr, {}, nullptr, tree_.forms[leaf.data]}; });
        case LeafKind::revolution:
            return kept(revolutions_[leaf.data], [&] { return Shape{tree_.profiles[leaf.data], {}, nullptr}; });
        case LeafKind::prism: {
            const auto& profile = tree_.profiles[leaf.data];
            const auto make = [&] {
                return Shape{profile, convex_prism_planes(*profile, leaf.a, most_planes), nullptr};
            };
            return leaf.a == 1 ? kept(prisms_[leaf.data], make) : std::make_shared<const Shape>(make());
        }
        default:
            return nullptr;
    }
}

SolvedLeaf solve(const Leaf& leaf, const Shape* shape) {
    SolvedLeaf out;
    out.a = leaf.a, out.b = leaf.b, out.material = leaf.material == Leaf::no_material ? 0 : leaf.material,
    out.shape = shape;
    if (leaf.kind == LeafKind::box && keeps_axes(leaf.to_world)) {
        const Vec3d corner = leaf.to_world.point({1, 1, 1});
        out.solver = Solver::axis_box;
        out.t = min(leaf.to_world.t, corner), out.row[0] = max(leaf.to_world.t, corner);
        return out;
    }
    if (const double r = leaf.kind == LeafKind::sphere ? uniform_scale(leaf.to_world) : 0; r > 0) {
        out.solver = Solver::ball;
        out.t = leaf.to_world.t, out.a = r;
        return out;
    }
    out.solver = shape && !shape->planes.empty() ? Solver::convex : general_solver(leaf.kind);
    const Affine to_local = leaf.to_world.inverse();
    out.t = to_local.t, out.row = to_local.row;
    return out;
}

Box3d leaf_bounds(const SolidTree& tree, const Leaf& leaf) {
    switch (leaf.kind) {
        case LeafKind::half_space:
            return Box3d::everything();
        case LeafKind::sphere:
            return sphere_bounds(leaf.to_world);
        case LeafKind::cone:
            return cone_bounds(leaf.to_world, leaf.a, leaf.b);
        case LeafKind::mesh: {
            Box3d box;
            for (const Vec3d& v : tree.meshes[leaf.data]->vertices) box.include(leaf.to_world.point(v));
            return box;
        }
        default:
            return leaf.to_world.box(local_bounds(tree, leaf));
    }
}

}  // namespace cardioid::csg
