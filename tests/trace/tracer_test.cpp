#include "rt_core/trace/tracer.hpp"

#include <gtest/gtest.h>

#include "csg/compile.hpp"
#include "csg/shapes/facets.hpp"
#include "tests/csg/models.hpp"

namespace cardioid {
namespace {

using csg::test::ball_leaf;
using csg::test::box_leaf;
using csg::test::Random;

Leaf of_material(Leaf leaf, std::uint32_t material) {
    leaf.material = material;
    return leaf;
}

/// A faceted ball of radius r at c as a triangle surface, twice as many scenes need one.
TriangleSurface mesh_ball(Vec3d c, double r, int n, std::uint32_t material) {
    TriangleSurface surface;
    surface.mesh = std::make_shared<const TriangleMesh>(csg::faceted_sphere(1, n));
    surface.to_world = Affine::translation(c) * Affine::scaling({r, r, r});
    surface.material = material;
    return surface;
}

TEST(Tracer, FindsTheNearestOfSolidsTrianglesAndLamps) {
    Scene scene;
    SolidTree& t = scene.solids;
    t.roots = {t.add_leaf(of_material(ball_leaf({0, 0, 0}, 1), 3))};
    Geometry geometry = csg::compile(scene, {});
    geometry.surfaces.push_back(mesh_ball({10, 0, 0}, 1, 32, 5));
    const LampShape lamp{LampShape::Kind::disc,
                         Affine::translation({5, 0, 0}) * Affine{{Vec3d{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}}, {}},
                         {1, 1}};
    const Tracer tracer(std::move(geometry), {lamp});

    const Hit from_left = tracer.intersect({{-20, 0, 0.01}, {1, 0, 0}, 1e9, {}, {}});
    ASSERT_TRUE(from_left.found());
    EXPECT_TRUE(tracer.is_region(from_left.id.region));
    EXPECT_EQ(tracer.material(from_left), 3U);
    EXPECT_NEAR(from_left.t, 20 - std::sqrt(1 - 1e-4), 1e-12);

    const Hit from_right = tracer.intersect({{20, 0.01, 0.02}, {-1, 0, 0}, 1e9, {}, {}});
    EXPECT_EQ(tracer.material(from_right), 5U);
    EXPECT_NEAR(from_right.t, 9, 0.02);
    EXPECT_GT(from_right.ng.x, 0.9F);

    const Hit between = tracer.intersect({{3, 0, 0}, {1, 0, 0}, 1e9, {}, {}});
    EXPECT_EQ(tracer.lamp(between.id.region), 0);
    EXPECT_NEAR(between.t, 2, 1e-12);
    EXPECT_EQ(between.id, tracer.lamp_face(0));
}

TEST(Tracer, TellsNothingWhereNothingIs) {
    const Tracer empty(Geometry{}, {});
    EXPECT_FALSE(empty.intersect({{0, 0, 0}, {1, 0, 0}, 1e9, {}, {}}).found());
    EXPECT_FALSE(empty.occluded({{0, 0, 0}, {1, 0, 0}, 1e9, {}, {}}));
    EXPECT_TRUE(empty.bounds().empty());
}

TEST(Tracer, OfTwoSolidsThatShareAFaceTheLaterOneShows) {
    for (const bool red_first : {true, false}) {
        Scene scene;
        SolidTree& t = scene.solids;
        const auto red = t.add_leaf(of_material(box_leaf({0, 0, 0}, {10, 10, 1}), 1));
        const auto blue = t.add_leaf(of_material(box_leaf({2, 2, 0.3}, {4, 4, 0.7}), 2));
        t.roots = red_first ? std::vector{red, blue} : std::vector{blue, red};
        const Tracer tracer(csg::compile(scene, {}), {});
        Random random(1);
        for (int i = 0; i < 2000; ++i) {
            const Vec3d target{random(2.1, 5.9), random(2.1, 5.9), 1}, o{random(-50, 50), random(-50, 50), 40};
            const Hit hit = tracer.intersect({o, normalize(target - o), 1e9, {}, {}});
            ASSERT_EQ(tracer.material(hit), red_first ? 2U : 1U) << i;
        }
    }
}

TEST(Tracer, OccludedAgreesWithIntersect) {
    Scene scene;
    SolidTree& t = scene.solids;
    Random random(2);
    for (int i = 0; i < 20; ++i) t.roots.push_back(t.add_leaf(csg::test::random_leaf(random)));
    Leaf ground;
    ground.kind = LeafKind::half_space;
    t.roots.push_back(t.add_leaf(ground));
    Geometry geometry = csg::compile(scene, {});
    geometry.surfaces.push_back(mesh_ball({5, 5, 5}, 2, 24, 0));
    const Tracer tracer(std::move(geometry), {});
    for (int i = 0; i < 20000; ++i) {
        const Ray ray{random.point(-5, 15), random.direction(), random(0.1, 20), {}, {}};
        const Hit hit = tracer.intersect({ray.o, ray.d, 1e9, {}, {}});
        if (std::abs(hit.t - ray.t_max) < 1e-5) continue;  // triangles are met in single precision
        ASSERT_EQ(tracer.occluded(ray), hit.t < ray.t_max) << i;
    }
}

TEST(Tracer, ARayThatLeavesAConvexMeshMeetsItNoMore) {
    for (const double size : {1e-3, 1.0, 1e5}) {
        Geometry geometry;
        geometry.surfaces.push_back(mesh_ball(Vec3d{3, 4, 5} * size, size, 60, 0));
        const Tracer tracer(std::move(geometry), {});
        Random random(3);
        int hits = 0;
        for (int i = 0; i < 50000; ++i) {
            const Vec3d d = random.direction(), o = (Vec3d{3, 4, 5} + random.point(-1, 1) - d * 10.0) * size;
            const Ray ray{o, d, 1e12, {}, {}};
            Hit hit = tracer.intersect(ray);
            if (!hit.found()) continue;
            tracer.refine(ray, hit);
            ++hits;
            // Reflected about the facet, and along it but for a little.
            const Vec3d n(hit.ng);
            const Vec3d along = normalize(cross(n, random.direction()));
            for (const Vec3d& out : {d - n * (2 * dot(d, n)), normalize(along + n * 1e-3)})
                ASSERT_FALSE(tracer.intersect({o + d * hit.t, out, 1e12, hit.id, hit.ng}).found()) << size << ' ' << i;
        }
        EXPECT_GT(hits, 10000);
    }
}

TEST(Tracer, PlacesOnTrianglesAreRefinedToDoublePrecision) {
    Geometry geometry;
    TriangleMesh square;
    square.vertices = {{-1e3, -1e3, 0}, {1e3, -1e3, 0}, {1e3, 1e3, 0}, {-1e3, 1e3, 0}};
    square.triangles = {{0, 1, 2}, {0, 2, 3}};
    geometry.surfaces.push_back({std::make_shared<const TriangleMesh>(square), {}, 0});
    const Tracer tracer(std::move(geometry), {});
    Random random(4);
    for (int i = 0; i < 1000; ++i) {
        const Vec3d o{random(-100, 100), random(-100, 100), 333.3},
            d = normalize(Vec3d{random(-1, 1), random(-1, 1), -1});
        Hit hit = tracer.intersect({o, d, 1e12, {}, {}});
        ASSERT_TRUE(hit.found());
        tracer.refine({o, d, 1e12, {}, {}}, hit);
        EXPECT_NEAR((o + d * hit.t).z, 0, 1e-12);
        EXPECT_EQ(hit.ng, Vec3(0, 0, 1));
    }
}

TEST(Tracer, MirroredSurfacesKeepTheirOutside) {
    Geometry geometry;
    geometry.surfaces.push_back(mesh_ball({0, 0, 0}, 1, 24, 0));
    geometry.surfaces[0].to_world = Affine::scaling({-1, 1, 1});
    const Tracer tracer(std::move(geometry), {});
    const Hit hit = tracer.intersect({{5, 0.1, 0.1}, {-1, 0, 0}, 1e9, {}, {}});
    ASSERT_TRUE(hit.found());
    EXPECT_GT(hit.ng.x, 0.5F);
}

TEST(Tracer, RaysThatAreNowhereMeetNothing) {
    Scene scene;
    scene.solids.roots = {scene.solids.add_leaf(ball_leaf({0, 0, 0}, 1))};
    const Tracer tracer(csg::compile(scene, {}), {});
    for (const Vec3d& o : {Vec3d{1e300, 0, 0}, Vec3d{0, NAN, 0}, Vec3d{0, 0, -INFINITY}}) {
        EXPECT_FALSE(tracer.intersect({o, {1, 0, 0}, 1e9, {}, {}}).found());
        EXPECT_FALSE(tracer.occluded({o, {1, 0, 0}, 1e9, {}, {}}));
    }
    EXPECT_FALSE(tracer.intersect({{0, 0, -5}, {NAN, 0, 1}, 1e9, {}, {}}).found());
}

TEST(Tracer, CountsItsMemory) {
    Scene scene;
    scene.solids.roots = {scene.solids.add_leaf(ball_leaf({0, 0, 0}, 1))};
    Geometry geometry = csg::compile(scene, {});
    geometry.surfaces.push_back(mesh_ball({5, 0, 0}, 1, 128, 0));
    const Tracer tracer(std::move(geometry), {});
    const TracerMemory memory = tracer.memory();
    EXPECT_EQ(memory.leaves, 1U);
    EXPECT_GT(memory.triangle_count, 10000U);
    EXPECT_GT(memory.embree, 60 * memory.triangle_count);
    EXPECT_LT(memory.triangles, 50 * memory.triangle_count);
}

}  // namespace
}  // namespace cardioid
