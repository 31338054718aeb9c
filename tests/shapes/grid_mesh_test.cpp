#include "csg/shapes/grid_mesh.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <optional>

#include "csg/leaves/mesh_shape.hpp"
#include "csg/shapes/mesh_repair.hpp"
#include "tests/csg/models.hpp"

namespace cardioid::csg {
namespace {

using test::Random;

std::shared_ptr<const TriangleMesh> shared(TriangleMesh mesh) {
    return std::make_shared<const TriangleMesh>(std::move(mesh));
}

/// Points of lines through corners and along edges are inside after an odd number of events: inside(p) says which are,
/// and nothing for what is too near to the surface.
template <class Inside>
void expect_members(const TriangleMesh& mesh, const Inside& inside) {
    const MeshShape shape(shared(mesh));
    Random random(11);
    std::size_t last = 0, seen = 0;
    for (int i = 0; i < 2000; ++i) {
        const auto at = static_cast<std::size_t>(random.whole(0, static_cast<int>(mesh.vertices.size()) - 1));
        const Vec3d p = mesh.vertices[at], to = mesh.vertices[last] - p;
        const Vec3d d = i % 2 && length(to) > 0 ? normalize(to) : random.direction();
        last = at;
        EventList events;
        shape.append_events(0, p - d * 50.0, d, events);
        ASSERT_EQ(events.size() % 2, 0U);
        for (int k = 0; k < 40; ++k) {
            const double t = random(40, 60);
            const std::optional<bool> wanted = inside(p + d * (t - 50));
            if (!wanted) continue;
            const auto before = std::count_if(events.begin(), events.end(), [&](const Event& e) { return e.t < t; });
            ASSERT_EQ(before % 2 == 1, *wanted);
            seen += *wanted;
        }
    }
    EXPECT_GT(seen, 1000U);
}

bool on_grid(double x) { return std::abs(x - std::round(x)) < 1e-6; }

TEST(GridMeshes, OfHeightsAreClosedAndOfTheirVolumeWhereTheGroundIsFlat) {
    Random random(10);
    std::vector<double> heights(7 * 9);
    for (double& h : heights) h = std::max(0.0, std::floor(random(-4, 6)));
    for (const CellCut cut : {CellCut::rising, CellCut::falling, CellCut::adaptive}) {
        const TriangleMesh mesh = height_mesh(heights, 7, cut);
        EXPECT_TRUE(mesh.closed);
        if (cut != CellCut::rising) continue;
        expect_members(mesh, [&](Vec3d p) -> std::optional<bool> {
            if (p.x < -1e-6 || p.x > 6 + 1e-6 || p.y < -1e-6 || p.y > 8 + 1e-6 || p.z < -1e-6) return false;
            if (on_grid(p.x) || on_grid(p.y) || std::abs(p.z) < 1e-6) return std::nullopt;
            const double fx = p.x - std::floor(p.x), fy = p.y - std::floor(p.y);
            const auto at = static_cast<std::size_t>(std::floor(p.y)) * 7 + static_cast<std::size_t>(std::floor(p.x));
            const double a = heights[at], b = heights[at + 1], c = heights[at + 7], d = heights[at + 8];
            const double h = fx > fy ? a + (b - a) * fx + (d - b) * fy : a + (c - a) * fy + (d - c) * fx;
            return std::abs(p.z - h) < 1e-6 ? std::nullopt : std::optional(p.z < h);
        });
    }
    double sum = 0;
    for (std::size_t y = 0; y < 8; ++y)
        for (std::size_t x = 0; x < 6; ++x)
            sum += (2 * heights[y * 7 + x] + heights[y * 7 + x + 1] + heights[y * 7 + x + 7] +
                    2 * heights[y * 7 + x + 8]) /
                   6;
    EXPECT_NEAR(volume(height_mesh(heights, 7, CellCut::rising)), sum, 1e-12 * sum);
}

TEST(GridMeshes, AreCutAlongTheFlatterDiagonal) {
    std::vector<double> valley(25), across(25);
    for (std::size_t i = 0; i < 25; ++i) {
        const double x = double(i % 5), y = double(i / 5);
        valley[i] = 10 + (x - y) * (x - y), across[i] = 10 + (x + y - 4) * (x + y - 4);
    }
    const auto volume_of = [](const std::vector<double>& h, CellCut cut) { return volume(height_mesh(h, 5, cut)); };
    EXPECT_DOUBLE_EQ(volume_of(valley, CellCut::adaptive), volume_of(valley, CellCut::rising));
    EXPECT_DOUBLE_EQ(volume_of(across, CellCut::adaptive), volume_of(across, CellCut::falling));
    EXPECT_GT(std::abs(volume_of(valley, CellCut::falling) - volume_of(valley, CellCut::rising)), 1);
}

TEST(GridMeshes, OfCellsThatTouchAtEdgesAndCornersAreClosed) {
    Random random(12);
    std::vector<bool> full(5 * 4 * 6);
    std::size_t count = 0;
    for (std::size_t i = 0; i < full.size(); ++i) full[i] = random(0, 1) < 0.5, count += full[i];
    const auto at = [&](std::size_t x, std::size_t y, std::size_t z) { return bool(full[(z * 4 + y) * 5 + x]); };
    const CellMesh cells = cell_mesh(5, 4, 6, at, 10'000);
    EXPECT_TRUE(cells.mesh.closed);
    EXPECT_NEAR(volume(cells.mesh), double(count), 1e-9);
    expect_members(cells.mesh, [&](Vec3d p) -> std::optional<bool> {
        if (on_grid(p.x) || on_grid(p.y) || on_grid(p.z)) return std::nullopt;
        if (p.x < 0 || p.y < 0 || p.z < 0 || p.x > 5 || p.y > 4 || p.z > 6) return false;
        return at(static_cast<std::size_t>(p.x), static_cast<std::size_t>(p.y), static_cast<std::size_t>(p.z));
    });
    EXPECT_TRUE(cell_mesh(5, 4, 6, at, 10).too_many);
}

TEST(GridMeshes, WithoutACellAreEmpty) {
    EXPECT_TRUE(height_mesh({1, 2, 3}, 3, CellCut::rising).triangles.empty());
    EXPECT_TRUE(height_mesh({1, 2, 3}, 1, CellCut::rising).triangles.empty());
}

}  // namespace
}  // namespace cardioid::csg
