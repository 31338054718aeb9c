#include <cmath>
#include <gtest/gtest.h>

#include "csg/leaves/solvers.hpp"
#include "csg/shapes/extrude.hpp"
#include "tests/csg/models.hpp"

namespace cardioid::csg {
namespace {

using test::Random;

EventList events_of(const Leaf& leaf, const SolidTree& tree, Vec3d o, Vec3d d) {
    ShapeMaker shapes(tree);
    const auto shape = shapes.shape_of(leaf);
    EventList out;
    append_events(solve(leaf, shape.get()), 0, o, d, out);
    return out;
}

/// Every leaf's promise: an even number of events, sorted, entering and leaving in turn.
void expect_well_formed(const EventList& events) {
    ASSERT_EQ(events.size() % 2, 0U);
    for (std::size_t i = 0; i < events.size(); ++i) {
        ASSERT_EQ(events[i].entering, i % 2 == 0);
        if (i > 0) {
            ASSERT_LE(events[i - 1].t, events[i].t);
        }
    }
}

TEST(Leaf, EventsAreEvenAndSortedForGrazingAndFarRays) {
    Random random(1);
    for (int i = 0; i < 20000; ++i) {
        const Leaf leaf = test::random_leaf(random);
        const Vec3d d = random.direction();
        const double away = std::pow(10, random(0, 5));
        expect_well_formed(events_of(leaf, {}, random.point(0, 10) - d * away, d));
    }
}

/// (|p|^2 + R^2 - r^2)^2 - 4 R^2 (x^2 + y^2) in extended precision.
long double torus_function(long double R, long double r, Vec3d o, Vec3d d, long double t) {
    const long double x = o.x + t * d.x, y = o.y + t * d.y, z = o.z + t * d.z;
    const long double k = x * x + y * y + z * z + R * R - r * r;
    return k * k - 4 * R * R * (x * x + y * y);
}

TEST(Torus, RootsLieOnTheSurfaceAndSeparateInsideFromOutside) {
    Random random(2);
    for (const double r : {0.5, 0.1, 0.01}) {
        for (const double away : {3.0, 100.0, 1e4}) {
            for (int i = 0; i < 20000; ++i) {
                // Half of the rays graze the tube within 1e-6 r.
                const double ring = random(0, 2 * M_PI), tube = random(0, 2 * M_PI);
                const Vec3d radial{std::cos(ring), std::sin(ring), 0};
                const Vec3d n = radial * std::cos(tube) + Vec3d{0, 0, std::sin(tube)};
                const double depth = i % 2 ? random(-r, r) : r * (1 + 1e-6 * random(-1, 1));
                const Vec3d d = i % 2 ? random.direction() : normalize(cross(n, random.direction()));
                const Vec3d o = radial + n * depth - d * away;
                std::array<double, 4> roots;
                const int count = torus_roots(1, r, o, d, roots);
                ASSERT_EQ(count % 2, 0);
                double before = away - 3;
                for (int k = 0; k <= count; ++k) {
                    const double next = k < count ? roots[static_cast<std::size_t>(k)] : away + 3;
                    const auto value = torus_function(1, r, o, d, 0.5L * (static_cast<long double>(before) + next));
                    // The ray itself is rounded: its place by about `away` units in the last place, times the gradient
                    // 8 r.
                    if (std::abs(value) > 100 * away * 0x1p-52 * 8 * r) {
                        ASSERT_EQ(value < 0, k % 2 == 1)
                            << r << ' ' << away << ' ' << i << ": " << static_cast<double>(value) << " between "
                            << before << " and " << next;
                    }
                    before = next;
                }
            }
        }
    }
}

TEST(Torus, ARayThroughTheAxisMeetsFourExactPlaces) {
    std::array<double, 4> roots;
    ASSERT_EQ(torus_roots(3, 1, {-10, 0, 0}, {1, 0, 0}, roots), 4);
    const double wanted[] = {6, 8, 12, 14};
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(roots[i], wanted[i], 1e-13);
    EXPECT_EQ(torus_roots(3, 1, {0, 0, -10}, {0, 0, 1}, roots), 0);
}

TEST(Cone, AgreesWithItsImplicitForm) {
    Random random(4);
    for (int i = 0; i < 50000; ++i) {
        const double a = random.whole(0, 3) ? random(0.1, 2) : 0, b = a == 0 || random.whole(0, 1) ? random(0.1, 2) : a;
        const Vec3d d = i % 7 ? random.direction() : Vec3d{0, 0, 1}, o = random.point(-2, 2) - d * 10.0;
        const Span span = cone_span(a, b, o, d);
        for (int k = 0; k < 5; ++k) {
            const double t = random(7, 13);
            const Vec3d p = o + d * t;
            const double radius = a + (b - a) * p.z, rho = std::hypot(p.x, p.y);
            if (std::abs(rho - radius) < 1e-9 || std::abs(p.z) < 1e-9 || std::abs(p.z - 1) < 1e-9) continue;
            const bool inside = p.z > 0 && p.z < 1 && rho < radius;
            ASSERT_EQ(!span.empty() && t > span.t0 && t < span.t1, inside) << a << ' ' << b << ' ' << i;
        }
    }
}

/// The same solid as an exact leaf and as the mesh that the extrusion makes of it.
void expect_same_solid(const Leaf& exact, const SolidTree& tree, TriangleMesh mesh, unsigned seed) {
    SolidTree meshes;
    Leaf faceted;
    faceted.kind = LeafKind::mesh;
    faceted.data = meshes.add_mesh(std::move(mesh));
    Random random(seed);
    int hits = 0;
    for (int i = 0; i < 3000; ++i) {
        const Vec3d d = random.direction(), o = random.point(-3, 3) - d * 20.0;
        const EventList a = events_of(exact, tree, o, d), b = events_of(faceted, meshes, o, d);
        expect_well_formed(a);
        ASSERT_EQ(a.size(), b.size()) << i;
        for (std::size_t k = 0; k < a.size(); ++k) ASSERT_NEAR(a[k].t, b[k].t, 1e-9);
        hits += static_cast<int>(a.size());
    }
    EXPECT_GT(hits, 500);
}

const Profile cross_with_hole{
    {{{-3, -1}, {-1, -1}, {-1, -3}, {1, -3}, {1, -1}, {3, -1}, {3, 1}, {1, 1}, {1, 3}, {-1, 3}, {-1, 1}, {-3, 1}},
     {{-0.5, -0.5}, {-0.5, 0.5}, {0.5, 0.5}, {0.5, -0.5}}}};

TEST(Prism, IsTheSolidOfItsMesh) {
    for (const double top : {1.0, 0.5, 1.5}) {
        SolidTree tree;
        Leaf leaf;
        leaf.kind = LeafKind::prism;
        leaf.a = top;
        leaf.data = tree.add_profile(cross_with_hole);
        leaf.to_world = Affine::scaling({1, 1, 2.5});
        LinearExtrusion how;
        how.height = 2.5, how.scale = {top, top}, how.slices = 1;
        expect_same_solid(leaf, tree, linear_extrude(cross_with_hole, how), 5);
    }
}

TEST(Prism, AConvexOneIsSolvedAsPlanesAndIsTheSameSolid) {
    const Profile hexagon{{{{2, 0}, {1, 1.7}, {-1, 1.7}, {-2, 0}, {-1, -1.7}, {1, -1.7}}}};
    EXPECT_EQ(convex_prism_planes(hexagon, 1, 64).size(), 8U);
    EXPECT_TRUE(convex_prism_planes(cross_with_hole, 1, 64).empty());
    for (const double top : {1.0, 0.3}) {
        SolidTree tree;
        Leaf leaf;
        leaf.kind = LeafKind::prism;
        leaf.a = top;
        leaf.data = tree.add_profile(hexagon);
        LinearExtrusion how;
        how.height = 1, how.scale = {top, top}, how.slices = 1;
        expect_same_solid(leaf, tree, linear_extrude(hexagon, how), 6);
    }
}

TEST(Revolution, OfASquareIsATubeOfExactVolume) {
    SolidTree tree;
    Leaf leaf;
    leaf.kind = LeafKind::revolution;
    leaf.data = tree.add_profile({{{{1, 0}, {2, 0}, {2, 1.5}, {1, 1.5}}}});
    Random random(7);
    for (int i = 0; i < 20000; ++i) {
        const Vec3d d = random.direction(), o = random.point(-2, 2) - d * 10.0;
        const EventList events = events_of(leaf, tree, o, d);
        expect_well_formed(events);
        for (int k = 0; k < 4; ++k) {
            const double t = random(7, 13);
            const Vec3d p = o + d * t;
            const double rho = std::hypot(p.x, p.y);
            const bool inside = rho > 1 && rho < 2 && p.z > 0 && p.z < 1.5;
            const auto before = std::count_if(events.begin(), events.end(), [&](const Event& e) { return e.t < t; });
            ASSERT_EQ(before % 2 == 1, inside);
        }
    }
}

TEST(Revolution, OfAHalfDiscOfConesTouchesTheAxis) {
    SolidTree tree;
    Leaf leaf;
    leaf.kind = LeafKind::revolution;
    leaf.data = tree.add_profile({{{{0, -1}, {1, 0}, {0, 1}}}});  // two cones, base to base: rho + |z| < 1
    Random random(8);
    for (int i = 0; i < 20000; ++i) {
        const Vec3d d = i % 5 ? random.direction() : Vec3d{0, 0, 1}, o = random.point(-1, 1) - d * 10.0;
        const EventList events = events_of(leaf, tree, o, d);
        expect_well_formed(events);
        for (int k = 0; k < 4; ++k) {
            const double t = random(8.5, 11.5);
            const Vec3d p = o + d * t;
            const double margin = std::hypot(p.x, p.y) + std::abs(p.z) - 1;
            if (std::abs(margin) < 1e-9) continue;
            const auto before = std::count_if(events.begin(), events.end(), [&](const Event& e) { return e.t < t; });
            ASSERT_EQ(before % 2 == 1, margin < 0);
        }
    }
}

TEST(Leaf, BoundsContainEveryEvent) {
    Random random(9);
    for (int i = 0; i < 3000; ++i) {
        const Leaf leaf = test::random_leaf(random);
        const Box3d box = leaf_bounds({}, leaf).padded(1e-9);
        const Vec3d d = random.direction(), o = random.point(0, 10) - d * 20.0;
        for (const Event& e : events_of(leaf, {}, o, d)) ASSERT_TRUE(box.contains(o + d * e.t));
    }
}

TEST(Leaf, HalfSpaceHasOneFiniteFace) {
    Leaf leaf;
    leaf.kind = LeafKind::half_space;
    const EventList events = events_of(leaf, {}, {0, 0, 5}, {0, 0, -1});
    ASSERT_EQ(events.size(), 2U);
    EXPECT_EQ(events[0].t, 5);
    EXPECT_TRUE(std::isinf(events[1].t));
    EXPECT_EQ(events_of(leaf, {}, {0, 0, 5}, {1, 0, 0}).size(), 0U);
    EXPECT_EQ(events_of(leaf, {}, {0, 0, -5}, {1, 0, 0}).size(), 2U);
}

}  // namespace
}  // namespace cardioid::csg
