#include "csg/shapes/mesh_repair.hpp"

#include <gtest/gtest.h>

#include "csg/shapes/facets.hpp"
#include "rt_core/api/error.hpp"

namespace {

using namespace cardioid;
using namespace cardioid::csg;

/// Every triangle with corners of its own, as STL has it.
TriangleMesh scattered(const TriangleMesh& mesh) {
    TriangleMesh out;
    for (const auto& t : mesh.triangles) {
        const auto first = static_cast<std::uint32_t>(out.vertices.size());
        for (const std::uint32_t v : t) out.vertices.push_back(mesh.vertices[v]);
        out.triangles.push_back({first, first + 1, first + 2});
    }
    return out;
}

TEST(Weld, JoinsEqualCornersAndLeavesOutUnusedOnes) {
    const TriangleMesh ball = faceted_sphere(3, 12);
    TriangleMesh soup = scattered(ball);
    soup.vertices.push_back({1e9, 0, 0});
    soup.vertices[0] = soup.vertices[0] + Vec3d{-0.0, -0.0, -0.0};
    const MeshFaults faults = weld(soup);
    EXPECT_TRUE(soup.closed);
    EXPECT_TRUE(faults.closed());
    EXPECT_EQ(soup.vertices.size(), ball.vertices.size());
    EXPECT_EQ(volume(soup), volume(ball));
}

TEST(Weld, TakesMinusZeroAsZero) {
    TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0, 0, -0.0}, {0, 1, -0.0}, {-1, 0, 0}},
                      {{0, 1, 2}, {3, 4, 5}}};
    weld(mesh);
    EXPECT_EQ(mesh.vertices.size(), 4U);
}

TEST(Weld, TellsWhereAMeshIsOpen) {
    TriangleMesh mesh = faceted_cone(1, 1, 1, 6);
    mesh.triangles.pop_back();
    const MeshFaults faults = weld(mesh);
    EXPECT_FALSE(mesh.closed);
    EXPECT_EQ(faults.open_edges, 3U);
    ASSERT_EQ(faults.where.size(), 3U);
    for (const Vec3d p : faults.where) EXPECT_EQ(p.z, 1);
}

TEST(Weld, DropsAndCountsFacesThatAreNone) {
    TriangleMesh mesh = faceted_cone(1, 1, 1, 6);
    mesh.vertices.push_back({NAN, 0, 0});
    mesh.triangles.push_back({0, 1, 99});
    mesh.triangles.push_back({0, 1, 1});
    mesh.triangles.push_back({0, 1, 12});
    EXPECT_EQ(weld(mesh).dropped_faces, 3U);
    EXPECT_TRUE(mesh.closed);
}

TEST(Weld, KeepsTrianglesWithoutAreaThatCloseTheMesh) {
    // A square pyramid whose base has a corner in the middle of one side, closed by a triangle of no area.
    TriangleMesh mesh{{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 1}, {1, 0, 0}},
                      {{0, 3, 1}, {1, 3, 2}, {0, 1, 5}, {0, 5, 4}, {5, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}};
    EXPECT_EQ(weld(mesh).dropped_faces, 0U);
    EXPECT_TRUE(mesh.closed);
}

TEST(Weld, TakesEdgesWithFourTrianglesAsClosedWherePairsOppose) {
    TriangleMesh two = faceted_cone(1, 1, 1, 4);
    const auto count = static_cast<std::uint32_t>(two.vertices.size());
    const TriangleMesh other = two;
    for (const Vec3d p : other.vertices) two.vertices.push_back(p + Vec3d{2, 0, 0});
    for (const auto& t : other.triangles) two.triangles.push_back({t[0] + count, t[1] + count, t[2] + count});
    EXPECT_TRUE(weld(two).closed());
    EXPECT_EQ(two.vertices.size(), 14U);
}

TEST(Repair, TurnsAMeshThatIsInsideOut) {
    TriangleMesh mesh = faceted_sphere(3, 12);
    for (auto& t : mesh.triangles) std::swap(t[0], t[1]);
    EXPECT_TRUE(repair(mesh).inside_out);
    EXPECT_GT(volume(mesh), 0);
    EXPECT_FALSE(repair(mesh).inside_out);
}

TEST(Repair, TurnsSingleTrianglesThatRunAgainstTheirNeighbours) {
    TriangleMesh mesh = faceted_sphere(3, 12);
    const double before = volume(mesh);
    for (std::size_t t = 0; t < mesh.triangles.size(); t += 7) std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
    TriangleMesh as_is = mesh;
    EXPECT_GT(weld(as_is).crowded_edges, 0U);
    EXPECT_TRUE(repair(mesh).closed());
    EXPECT_NEAR(volume(mesh), before, 1e-12);
}

TEST(Repair, TakesAnEmptyMesh) {
    TriangleMesh mesh;
    EXPECT_TRUE(repair(mesh).closed());
    EXPECT_EQ(volume(mesh), 0);
}

TEST(Volume, KeepsItsDigitsFarFromTheOrigin) {
    TriangleMesh mesh = faceted_cone(1, 1, 1, 4);
    for (Vec3d& p : mesh.vertices) p += Vec3d{0x1p30, 0x1p31, 0x1p32};
    EXPECT_DOUBLE_EQ(volume(mesh), 2);
}

using Faces = std::vector<std::vector<std::uint32_t>>;
const std::vector<Vec3d> cube_points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                     {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
const Faces cube_faces{{0, 1, 2, 3}, {4, 7, 6, 5}, {0, 4, 5, 1}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}};

TEST(Polyhedron, OfClockwiseFacesIsTurnedOutwards) {
    MeshFaults faults;
    TriangleMesh mesh = triangulate_polyhedron(cube_points, cube_faces, faults);
    EXPECT_EQ(mesh.triangles.size(), 12U);
    EXPECT_EQ(volume(mesh), 1);
    EXPECT_EQ(faults.dropped_faces + faults.non_planar_faces, 0U);
    EXPECT_TRUE(repair(mesh).closed());
}

TEST(Polyhedron, LeavesOutAndCountsBadFaces) {
    Faces faces = cube_faces;
    faces.push_back({0, 1, 8});
    faces.push_back({0, 1});
    faces.push_back({});
    MeshFaults faults;
    TriangleMesh mesh = triangulate_polyhedron(cube_points, faces, faults);
    EXPECT_EQ(faults.dropped_faces, 3U);
    EXPECT_TRUE(repair(mesh).closed());
}

TEST(Polyhedron, CutsFacesThatAreNotConvexOrHaveHoles) {
    // A block with an L-shaped lid, and one with a keyhole: the lid's contour runs to the hole and back.
    const std::vector<Vec2d> bent{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};
    const std::vector<Vec2d> keyhole{{0, 0}, {3, 0}, {3, 3}, {0, 3}, {0, 0}, {1, 1}, {1, 2}, {2, 2}, {2, 1}, {1, 1}};
    for (const auto& [outline, area] : {std::pair(bent, 5.0), std::pair(keyhole, 8.0)}) {
        const auto n = static_cast<std::uint32_t>(outline.size());
        std::vector<Vec3d> points;
        for (const double z : {0.0, 2.0})
            for (const Vec2d p : outline) points.push_back({z, p.x, p.y});
        Faces faces(2);
        for (std::uint32_t i = 0; i < n; ++i) {
            faces[0].push_back(i);
            faces[1].push_back(2 * n - 1 - i);
            faces.push_back({i, i + n, (i + 1) % n + n, (i + 1) % n});
        }
        MeshFaults faults;
        TriangleMesh mesh = triangulate_polyhedron(points, faces, faults);
        EXPECT_EQ(faults.non_planar_faces, 0U);
        EXPECT_TRUE(repair(mesh).closed());
        EXPECT_NEAR(volume(mesh), 2 * area, 1e-12);
    }
}

TEST(Polyhedron, FansFacesWithoutAreaSoThatNoHoleIsLeft) {
    MeshFaults faults;
    const std::vector<Vec3d> line{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}};
    EXPECT_EQ(triangulate_polyhedron(line, {{0, 1, 2, 3}}, faults).triangles.size(), 2U);
}

TEST(Polyhedron, CountsFacesThatAreNotPlanarBeyondSixDigits) {
    std::vector<Vec3d> points = cube_points;
    points[6].z += 1e-6;
    MeshFaults faults;
    triangulate_polyhedron(points, cube_faces, faults);
    EXPECT_EQ(faults.non_planar_faces, 0U);
    points[6].z += 0.001;
    triangulate_polyhedron(points, cube_faces, faults);
    EXPECT_EQ(faults.non_planar_faces, 1U);
}

TEST(Triangulate, NumbersTheConcatenatedPoints) {
    const auto out = triangulate({{{{0, 0}, {1, 0}, {0, 1}}, {{5, 5}, {6, 5}, {5, 6}}}});
    ASSERT_EQ(out.size(), 2U);
    for (const auto& t : out) EXPECT_EQ(t[0] / 3, t[1] / 3);
    EXPECT_THROW(triangulate({{{{0, 0}, {2, 2}, {2, 0}, {0, 2}}}}), Error);
}

}  // namespace
