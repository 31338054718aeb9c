#include "csg/shapes/grid_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "csg/shapes/mesh_repair.hpp"

namespace cardioid::csg {

namespace {

using Triangle = std::array<std::uint32_t, 3>;

class HeightGrid {
public:
    HeightGrid(const std::vector<double>& heights, std::size_t width)
        : heights_(heights), width_(width), rows_(heights.size() / width) {}

    [[nodiscard]] std::size_t rows() const { return rows_; }
    [[nodiscard]] std::size_t index(std::size_t x, std::size_t y) const { return y * width_ + x; }
    [[nodiscard]] double at(std::size_t x, std::size_t y) const { return heights_[index(x, y)]; }

    /// Whether the cell is cut along (0, 0) - (1, 1): curvature along both diagonals, from the samples at and behind
    /// their ends.
    [[nodiscard]] bool rises(std::size_t x, std::size_t y) const {
        const std::size_t x0 = x > 0 ? x - 1 : 0, y0 = y > 0 ? y - 1 : 0;
        const std::size_t x3 = std::min(x + 2, width_ - 1), y3 = std::min(y + 2, rows_ - 1);
        const auto bend = [](double before, double a, double b, double behind) {
            return std::abs(b + before - 2 * a) + std::abs(behind + a - 2 * b);
        };
        return bend(at(x0, y0), at(x, y), at(x + 1, y + 1), at(x3, y3)) <
               bend(at(x3, y0), at(x + 1, y), at(x, y + 1), at(x0, y3));
    }

private:
    const std::vector<double>& heights_;
    std::size_t width_, rows_;
};

}  // namespace

TriangleMesh height_mesh(const std::vector<double>& heights, std::size_t width, CellCut cut) {
    TriangleMesh mesh;
    if (width < 2 || heights.size() < 2 * width) return mesh;
    const HeightGrid grid(heights, width);
    const std::size_t points = width * grid.rows();
    mesh.vertices.reserve(2 * points);
    for (const bool top : {true, false})
        for (std::size_t i = 0; i < points; ++i)
            mesh.vertices.push_back({double(i % width), double(i / width), top ? heights[i] : 0});
    const auto below = static_cast<std::uint32_t>(points);
    const auto both_sides = [&](const Triangle& t) {
        if (heights[t[0]] == 0 && heights[t[1]] == 0 && heights[t[2]] == 0) return;
        mesh.triangles.push_back(t);
        mesh.triangles.push_back({t[0] + below, t[2] + below, t[1] + below});
    };
    // Seen from outside the first two points run from left to right.
    const auto wall = [&](std::size_t left, std::size_t right) {
        const auto l = static_cast<std::uint32_t>(left), r = static_cast<std::uint32_t>(right);
        mesh.triangles.push_back({l + below, r + below, r});
        mesh.triangles.push_back({l + below, r, l});
    };
    for (std::size_t y = 0; y + 1 < grid.rows(); ++y)
        for (std::size_t x = 0; x + 1 < width; ++x) {
            const auto a = static_cast<std::uint32_t>(grid.index(x, y)), b = a + 1;
            const auto c = static_cast<std::uint32_t>(grid.index(x, y + 1)), d = c + 1;
            if (cut == CellCut::rising || (cut == CellCut::adaptive && grid.rises(x, y)))
                both_sides({a, b, d}), both_sides({a, d, c});
            else
                both_sides({a, b, c}), both_sides({b, d, c});
        }
    const std::size_t last_row = grid.rows() - 1, last = width - 1;
    for (std::size_t x = 0; x < last; ++x) {
        wall(grid.index(x, 0), grid.index(x + 1, 0));
        wall(grid.index(x + 1, last_row), grid.index(x, last_row));
    }
    for (std::size_t y = 0; y < last_row; ++y) {
        wall(grid.index(0, y + 1), grid.index(0, y));
        wall(grid.index(last, y), grid.index(last, y + 1));
    }
    weld(mesh);
    return mesh;
}

namespace {

/// Corners of the faces of a layer of cells: those on the plane below and above it, each made once.
class LayerCorners {
public:
    LayerCorners(std::size_t w, std::size_t n, TriangleMesh& mesh) : row_(w + 1), mesh_(mesh) {
        for (auto& plane : planes_) plane.assign(row_ * (n + 1), none);
    }
    void begin(std::size_t z) {
        z_ = z;
        std::swap(planes_[0], planes_[1]);
        std::fill(planes_[1].begin(), planes_[1].end(), none);
    }
    std::uint32_t at(std::size_t x, std::size_t y, std::size_t above) {
        std::uint32_t& place = planes_[above][y * row_ + x];
        if (place == none) {
            place = static_cast<std::uint32_t>(mesh_.vertices.size());
            mesh_.vertices.push_back({double(x), double(y), double(z_ + above)});
        }
        return place;
    }

private:
    static constexpr std::uint32_t none = 0xFFFFFFFFU;
    std::size_t row_, z_ = 0;
    TriangleMesh& mesh_;
    std::array<std::vector<std::uint32_t>, 2> planes_;
};

/// Corners of a cell's six faces, counter-clockwise from outside: bits 1, 2 and 4 are a step along x, y and z.
struct CellFace {
    int dx, dy, dz;
    std::array<unsigned, 4> corners;
};
constexpr std::array<CellFace, 6> cell_faces{{{-1, 0, 0, {0, 4, 6, 2}},
                                              {1, 0, 0, {1, 3, 7, 5}},
                                              {0, -1, 0, {0, 1, 5, 4}},
                                              {0, 1, 0, {2, 6, 7, 3}},
                                              {0, 0, -1, {0, 2, 3, 1}},
                                              {0, 0, 1, {4, 5, 7, 6}}}};

}  // namespace

CellMesh cell_mesh(std::size_t w, std::size_t n, std::size_t d,
                   const std::function<bool(std::size_t, std::size_t, std::size_t)>& full, std::size_t most) {
    CellMesh out;
    LayerCorners corners(w, n, out.mesh);
    // A step below 0 wraps to a number beyond every size.
    const auto is_full = [&](std::size_t x, std::size_t y, std::size_t z) {
        return x < w && y < n && z < d && full(x, y, z);
    };
    for (std::size_t z = 0; z < d; ++z) {
        corners.begin(z);
        for (std::size_t y = 0; y < n; ++y)
            for (std::size_t x = 0; x < w; ++x) {
                if (!full(x, y, z)) continue;
                for (const CellFace& face : cell_faces) {
                    if (is_full(x + static_cast<std::size_t>(face.dx), y + static_cast<std::size_t>(face.dy),
                                z + static_cast<std::size_t>(face.dz)))
                        continue;
                    if (out.mesh.triangles.size() / 2 == most) return {.mesh = {}, .too_many = true};
                    std::array<std::uint32_t, 4> p;
                    for (std::size_t i = 0; i < 4; ++i) {
                        const unsigned c = face.corners[i];
                        p[i] = corners.at(x + (c & 1), y + (c >> 1 & 1), c >> 2);
                    }
                    out.mesh.triangles.push_back({p[0], p[1], p[2]});
                    out.mesh.triangles.push_back({p[0], p[2], p[3]});
                }
            }
    }
    weld(out.mesh);
    return out;
}

}  // namespace cardioid::csg
