#include "csg/leaves/forms.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "csg/exact/tessellate.hpp"
#include "csg/measure.hpp"
#include "csg/shapes/mesh_repair.hpp"
#include "tests/csg/models.hpp"

namespace cardioid::csg {
namespace {

using test::Random;

constexpr double pi_d = std::numbers::pi;

struct Known {
    const char* name;
    Form form;
    double volume;
};

/// Area under sqrt(w u^2 + (1 - w) u), both sides, by Simpson's rule after u = s^2, which takes the root's edge away.
double trough_section(double w) {
    constexpr int steps = 2000;
    const auto f = [&](double s) { return 2 * std::sqrt(w * s * s * s * s + (1 - w) * s * s) * 2 * s; };
    double sum = f(0) + f(1);
    for (int i = 1; i < steps; ++i) sum += f(double(i) / steps) * (i % 2 ? 4 : 2);
    return sum / (3 * steps);
}

double superellipsoid_volume(double n, double e) {
    return 2 * n * e * std::beta(n / 2 + 1, n) * std::beta(e / 2, e / 2);
}

std::vector<Known> known_forms() {
    const double A = 30, B = 8, C = 20;
    return {{"paraboloid", {FormKind::bowl, {0}}, pi_d / 2},
            {"hyperboloid", {FormKind::bowl, {0.4}}, pi_d * (0.4 / 3 + 0.6 / 2)},
            {"parabolic trough", {FormKind::trough, {0}}, 4.0 / 3},
            {"hyperbolic trough", {FormKind::trough, {0.4}}, trough_section(0.4)},
            {"waist", {FormKind::waist, {0.2}}, 2 * pi_d * (0.2 + 0.8 / 3)},
            {"taper", {FormKind::taper, {0.3, 0.8}}, pi_d * (1 - (0.7 + 0.2) / 2 + 0.7 * 0.2 / 3)},
            {"edge", {FormKind::taper, {0, 1}}, pi_d / 2},
            {"tilted ring", {FormKind::tilted_ring, {1, A, B, C}}, 2 * pi_d * pi_d / std::sqrt(A * C - B * B / 4)},
            {"pillow", {FormKind::superellipsoid, {0.5, 0.7}}, superellipsoid_volume(0.5, 0.7)},
            {"octahedron", {FormKind::superellipsoid, {2, 2}}, 4.0 / 3},
            {"star", {FormKind::superellipsoid, {2.2, 2.1}}, superellipsoid_volume(2.2, 2.1)},
            {"spindle", {FormKind::superellipsoid, {2.2, 1}}, superellipsoid_volume(2.2, 1)},
            {"ball of a field",
             {FormKind::metaball, {1, 1.5625}, std::make_shared<const std::vector<Blob>>(1, Blob{{0.1, 0, 0}, 1, 1})},
             4.0 / 3 * pi_d * 0.512}};
}

SolidTree tree_of(const Form& form, const Affine& place) {
    SolidTree tree;
    tree.roots = {tree.add_leaf({.kind = LeafKind::form, .to_world = place, .data = tree.add_form(form)})};
    return tree;
}

Affine turned() {
    const Frame frame(normalize(Vec3{1, 2, 3}));
    return {{Vec3d(frame.s), Vec3d(frame.t), Vec3d(frame.n)}, {5, -7, 2}};
}

TEST(Forms, HaveTheVolumesOfTheirFormulas) {
    for (const Known& known : known_forms()) {
        const auto region = compile_whole(tree_of(known.form, turned()), false);
        const VolumeEstimate found = measure_volume(*region, region->bounds(), 64, 1);
        EXPECT_NEAR(found.volume, known.volume, 4 * found.sigma + 1e-6 * known.volume) << known.name;
        EXPECT_LT(found.sigma, 5e-3 * known.volume) << known.name;  // 2 % off would be seen
    }
}

TEST(Forms, AreMetAnEvenNumberOfTimesAlsoByGrazingAndFarRays) {
    Random random(3);
    for (const Known& known : known_forms()) {
        for (int i = 0; i < 3000; ++i) {
            // From a point of the surface, along the tangent plane for every other ray.
            const Vec3d through = random.point(-1, 1), d0 = random.direction();
            EventList events;
            append_form(known.form, 0, through - d0 * 3.0, d0, events);
            Vec3d o = through - d0 * std::pow(10, random(0, 4)), d = d0;
            if (!events.empty() && i % 2) {
                const Vec3d p = through - d0 * 3.0 + d0 * events[0].t;
                const Vec3d n = form_normal(known.form, events[0].face, p);
                if (!(length(n) > 1e-6)) continue;
                d = normalize(cross(n, random.direction()));
                o = p + normalize(n) * (1e-9 * random(-1, 1)) - d * std::pow(10, random(0, 4));
            }
            events.clear();
            append_form(known.form, 0, o, d, events);
            ASSERT_EQ(events.size() % 2, 0U) << known.name;
            for (std::size_t k = 0; k < events.size(); ++k) {
                ASSERT_EQ(events[k].entering, k % 2 == 0) << known.name;
                if (k > 0) {
                    ASSERT_LE(events[k - 1].t, events[k].t) << known.name;
                }
            }
        }
    }
}

TEST(Forms, CrossingsPartInsideFromOutsideAsTheFormulaDoes) {
    Random random(4);
    for (const Known& known : known_forms()) {
        const Box3d box = form_box(known.form);
        for (int i = 0; i < 2000; ++i) {
            const Vec3d p = random.point(-1.3, 1.3), d = random.direction();
            const double value = form_value(known.form, p);
            if (std::abs(value) < 1e-9 || !box.padded(1e-9).contains(p) != !box.padded(-1e-9).contains(p)) continue;
            EventList events;
            append_form(known.form, 0, p - d * 10.0, d, events);
            const auto before = std::count_if(events.begin(), events.end(), [](const Event& e) { return e.t < 10; });
            ASSERT_EQ(before % 2 == 1, value < 0 && box.contains(p)) << known.name;
        }
    }
}

TEST(Forms, NormalsPointOutwardWhereARayEntersAndLeaves) {
    Random random(5);
    for (const Known& known : known_forms()) {
        for (int i = 0; i < 500; ++i) {
            const Vec3d d = random.direction();
            EventList out;
            SolidTree tree = tree_of(known.form, {});
            ShapeMaker shapes(tree);
            const auto shape = shapes.shape_of(tree.leaves[0]);
            const SolvedLeaf leaf = solve(tree.leaves[0], shape.get());
            const Vec3d o = random.point(-0.8, 0.8) - d * 4.0;
            append_events(leaf, 0, o, d, out);
            for (const Event& event : out)
                EXPECT_GT((event.entering ? -1 : 1) * dot(normal(leaf, event.face, o + d * event.t), d), -1e-6)
                    << known.name;
        }
    }
}

TEST(Forms, MeshesOfThemAreClosedAndNearlyAsLarge) {
    for (const Known& known : known_forms()) {
        const SolidTree tree = tree_of(known.form, turned());
        const TriangleMesh mesh = tessellate(tree, tree.leaves[0], 1e-3);
        EXPECT_TRUE(mesh.closed) << known.name;
        EXPECT_NEAR(volume(mesh), known.volume, 0.02 * known.volume) << known.name;
    }
}

TEST(ConvexPlanes, OfACubesMeshMeetEveryRayAsTheCubeDoes) {
    SolidTree box;
    box.roots = {box.add_leaf({.kind = LeafKind::box})};
    SolidTree mesh;
    mesh.roots = {mesh.add_leaf({.kind = LeafKind::mesh, .data = mesh.add_mesh(tessellate(box, box.leaves[0], 0))})};
    ShapeMaker shapes(mesh);
    const auto shape = shapes.shape_of(mesh.leaves[0]);
    EXPECT_EQ(solve(mesh.leaves[0], shape.get()).solver, Solver::convex);
    EXPECT_EQ(shape->planes.size(), 6U);
    Random random(6);
    for (int i = 0; i < 5000; ++i) {
        const Vec3d d = random.direction(), o = random.point(0, 1) - d * 3.0;
        EventList a, b;
        append_events(solve(box.leaves[0], nullptr), 0, o, d, a);
        append_events(solve(mesh.leaves[0], shape.get()), 0, o, d, b);
        ASSERT_EQ(a.size(), b.size());
        for (std::size_t k = 0; k < a.size(); ++k) ASSERT_NEAR(a[k].t, b[k].t, 1e-12);
    }
}

/// Three points that melt together, one that bites, one apart, by each method.
std::vector<Form> metaballs() {
    const auto blobs = std::make_shared<const std::vector<Blob>>(std::vector<Blob>{{{-0.3, 0, 0}, 0.2, 1.5},
                                                                                   {{0.1, 0.1, 0}, 0.25, 2},
                                                                                   {{0.2, -0.2, 0.1}, 0.2, 1},
                                                                                   {{0, 0.3, 0}, -0.12, 2},
                                                                                   {{0.1, 0.2, 0.6}, 0.1, 4}});
    return {{FormKind::metaball, {0, 0.3}, blobs},
            {FormKind::metaball, {1, 1.2}, blobs},
            {FormKind::metaball, {2, 0.9}, blobs}};
}

TEST(Metaballs, AreMetWhereTheirFieldsSayAlsoByGrazingRays) {
    Random random(7);
    int grazing = 0;
    for (const Form& form : metaballs())
        for (int i = 0; i < 2000; ++i) {
            Vec3d d = random.direction(), p = random.point(-0.6, 0.6);
            EventList events;
            append_form(form, 0, p - d * 3.0, d, events);
            if (!events.empty() && i % 2) {
                const Vec3d q = p - d * 3.0 + d * events[0].t, n = normalize(form_normal(form, 6, q));
                d = normalize(cross(n, random.direction()));
                p = q + n * (1e-10 * random(-1, 1));
                events.clear();
                append_form(form, 0, p - d * 3.0, d, events);
                ++grazing;
            }
            ASSERT_EQ(events.size() % 2, 0U);
            // Samples of the line agree, but at the surface.
            for (int k = 1; k < 60; ++k) {
                const double t = 0.1 * k;
                const double value = form_value(form, p + d * (t - 3));
                if (std::abs(value) < 1e-9) continue;
                const auto before =
                    std::count_if(events.begin(), events.end(), [&](const Event& e) { return e.t < t; });
                ASSERT_EQ(before % 2 == 1, value < 0) << form.numbers[0] << ' ' << t;
            }
            for (const Event& event : events)
                ASSERT_NEAR(form_value(form, p + d * (event.t - 3)), 0, 1e-9) << form.numbers[0];
        }
    EXPECT_GT(grazing, 100);
}

TEST(Metaballs, MeshesOfThemAreClosedAndOfTheirVolume) {
    for (const Form& form : metaballs()) {
        const SolidTree tree = tree_of(form, turned());
        const TriangleMesh mesh = tessellate(tree, tree.leaves[0], 2e-3);
        EXPECT_TRUE(mesh.closed);
        const auto region = compile_whole(tree, false);
        const VolumeEstimate found = measure_volume(*region, region->bounds(), 96, 1);
        EXPECT_NEAR(volume(mesh), found.volume, 0.02 * found.volume + 4 * found.sigma);
    }
}

}  // namespace
}  // namespace cardioid::csg
