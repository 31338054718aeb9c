#include <gtest/gtest.h>

#include "csg/bvh/bvh8.hpp"
#include "csg/leaves/mesh_shape.hpp"
#include "csg/leaves/solvers.hpp"
#include "csg/shapes/facets.hpp"
#include "tests/csg/models.hpp"

namespace cardioid::csg {
namespace {

using test::Random;

struct Ball {
    std::shared_ptr<const TriangleMesh> mesh = std::make_shared<const TriangleMesh>(faceted_sphere(10, 64));
    MeshShape shape{mesh};
    std::vector<Plane> planes;

    Ball() {
        for (const auto& [a, b, c] : mesh->triangles) {
            const Vec3d n =
                normalize(cross(mesh->vertices[b] - mesh->vertices[a], mesh->vertices[c] - mesh->vertices[a]));
            planes.push_back({n, dot(n, mesh->vertices[a])});
        }
    }
    /// The convex mesh must be met just where its planes say, through faces, edges and corners alike.
    void expect_exact(Vec3d o, Vec3d d, double tolerance) const {
        EventList events;
        shape.append_events(0, o, d, events);
        const Span span = convex_span(planes, o, d);
        if (span.empty() || span.t1 - span.t0 < tolerance) {
            ASSERT_LE(events.size(), 2U);
            return;
        }
        ASSERT_EQ(events.size(), 2U);
        ASSERT_NEAR(events[0].t, span.t0, tolerance);
        ASSERT_NEAR(events[1].t, span.t1, tolerance);
    }
};

TEST(MeshParity, IsEvenThroughFaces) {
    const Ball ball;
    Random random(1);
    for (int i = 0; i < 5000; ++i) {
        const Vec3d d = random.direction();
        ball.expect_exact(random.point(-10, 10) - d * (i % 2 ? 100.0 : 1e4), d, 1e-6);
    }
}

TEST(MeshParity, IsEvenThroughEdges) {
    const Ball ball;
    Random random(2);
    const auto& mesh = *ball.mesh;
    for (int i = 0; i < 5000; ++i) {
        const auto& triangle =
            mesh.triangles[static_cast<std::size_t>(random.whole(0, static_cast<int>(mesh.triangles.size()) - 1))];
        const Vec3d a = mesh.vertices[triangle[0]], b = mesh.vertices[triangle[1]];
        const Vec3d target = a + (b - a) * random(0, 1), o = random.point(-1, 1) * (i % 2 ? 30.0 : 3e4);
        if (length(o) < 12) continue;
        ball.expect_exact(o, normalize(target - o), 1e-5);
    }
}

TEST(MeshParity, IsEvenThroughCorners) {
    const Ball ball;
    Random random(3);
    const auto& mesh = *ball.mesh;
    for (int i = 0; i < 5000; ++i) {
        const Vec3d target =
            mesh.vertices[static_cast<std::size_t>(random.whole(0, static_cast<int>(mesh.vertices.size()) - 1))];
        const Vec3d o = random.point(-1, 1) * (i % 2 ? 30.0 : 3e4);
        if (length(o) < 12) continue;
        ball.expect_exact(o, normalize(target - o), 1e-5);
    }
}

TEST(MeshParity, IsEvenForRaysThatHitGridCornersExactly) {
    // A cube of many squares: axis-parallel and diagonal rays from grid points run through corners and along edges.
    TriangleMesh cube;
    const int n = 4;
    const auto corner = [&](int x, int y, int z) {
        cube.vertices.push_back({static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
        return static_cast<std::uint32_t>(cube.vertices.size() - 1);
    };
    for (int axis = 0; axis < 3; ++axis)
        for (int side = 0; side < 2; ++side)
            for (int i = 0; i < n * n; ++i) {
                std::array<std::uint32_t, 4> q;
                for (int k = 0; k < 4; ++k) {
                    int p[3];
                    p[axis] = side * n;
                    p[(axis + 1) % 3] = i % n + (k == 1 || k == 2);
                    p[(axis + 2) % 3] = i / n + (k >= 2);
                    q[static_cast<std::size_t>(k)] = corner(p[0], p[1], p[2]);
                }
                if (side == 0) std::swap(q[1], q[3]);
                cube.triangles.push_back({q[0], q[1], q[2]});
                cube.triangles.push_back({q[0], q[2], q[3]});
            }
    const MeshShape shape(std::make_shared<const TriangleMesh>(cube));
    for (int x = -2; x <= 6; ++x)
        for (int y = -2; y <= 6; ++y)
            for (int dx = -2; dx <= 2; ++dx)
                for (int dy = -2; dy <= 2; ++dy) {
                    EventList events;
                    const Vec3d o{static_cast<double>(x), static_cast<double>(y), -2};
                    const Vec3d d{static_cast<double>(dx), static_cast<double>(dy), 1};
                    shape.append_events(0, o, d, events);
                    const Span span = axis_box_span({0, 0, 0}, {4, 4, 4}, o, d);
                    const bool inner = !span.empty() && span.t1 - span.t0 > 1e-9;
                    // Rays within a face may count either way, but never once.
                    ASSERT_EQ(events.size() % 2, 0U);
                    if (inner) {
                        ASSERT_EQ(events.size(), 2U) << x << ' ' << y << ' ' << dx << ' ' << dy;
                        ASSERT_NEAR(events[0].t, span.t0, 1e-12);
                        ASSERT_NEAR(events[1].t, span.t1, 1e-12);
                    }
                }
}

TEST(Bvh8, BothBoxTestsGiveTheSameResults) {
    Random random(4);
    std::vector<Box3d> boxes;
    for (int i = 0; i < 8; ++i) {
        const Vec3d p = random.point(-10, 10);
        boxes.push_back({p, p + random.point(0, 5)});
    }
    const Bvh8 bvh(boxes, 1);
    for (int i = 0; i < 20000; ++i) {
        Vec3 d(random.direction());
        if (i % 3 == 0) d.x = 0;
        const BoxRay ray{Vec3(random.point(-12, 12)), d};
        alignas(32) float a[8], b[8];
        const unsigned ma = hit_boxes_plain(bvh.node(0), ray, 0, 100, a), mb = hit_boxes(bvh.node(0), ray, 0, 100, b);
        ASSERT_EQ(ma, mb);
        for (unsigned k = 0; k < 8; ++k)
            if (ma >> k & 1) {
                ASSERT_EQ(a[k], b[k]);
            }
    }
}

}  // namespace
}  // namespace cardioid::csg
