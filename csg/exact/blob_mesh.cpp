#include <algorithm>
#include <array>

#include "csg/exact/form_mesh.hpp"
#include "csg/leaves/blobs.hpp"
#include "csg/leaves/crossings.hpp"

namespace cardioid::csg {

namespace {

constexpr int most_cells = 128;
/// Half the grid's side: a little beyond the form's box, so that its outermost points are outside.
constexpr double reach = 1.001;

/// Corners of a cell (bits 1, 2 and 4: a step along x, y and z) of the six tetrahedra along its diagonal (Kuhn 1960),
/// each turned so that (b - a) x (c - a) . (d - a) > 0. Neighbours' faces agree.
constexpr unsigned tetrahedra[6][4] = {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7},
                                       {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}};
/// Even orders of a tetrahedron's corners by which of them are inside: first those inside, else, where three are, the
/// one outside.
constexpr unsigned orders[16][4] = {
    {},           {0, 1, 2, 3}, {1, 0, 3, 2}, {0, 1, 2, 3}, {2, 0, 1, 3}, {0, 2, 3, 1}, {1, 2, 0, 3}, {3, 0, 2, 1},
    {3, 0, 2, 1}, {0, 3, 1, 2}, {1, 3, 2, 0}, {2, 0, 1, 3}, {2, 3, 0, 1}, {1, 0, 3, 2}, {0, 1, 2, 3}, {}};

class BlobGrid {
public:
    BlobGrid(const Form& form, int cells)
        : form_(form), cells_(static_cast<std::size_t>(cells)), values_((cells_ + 1) * (cells_ + 1) * (cells_ + 1)) {
        for (std::size_t i = 0; i < values_.size(); ++i) values_[i] = blob_value(form, point(i));
    }

    TriangleMesh mesh() {
        for (std::size_t z = 0; z < cells_; ++z)
            for (std::size_t y = 0; y < cells_; ++y)
                for (std::size_t x = 0; x < cells_; ++x) cell(x, y, z);
        return std::move(mesh_);
    }

private:
    [[nodiscard]] Vec3d point(std::size_t i) const {
        const std::size_t n = cells_ + 1;
        const auto along = [&](std::size_t k) {
            return reach * (2 * static_cast<double>(k) / static_cast<double>(cells_) - 1);
        };
        return {along(i % n), along(i / n % n), along(i / n / n)};
    }

    void cell(std::size_t x, std::size_t y, std::size_t z) {
        const std::size_t n = cells_ + 1;
        for (const auto& corners : tetrahedra) {
            std::array<std::size_t, 4> p;
            unsigned inside = 0;
            for (unsigned i = 0; i < 4; ++i) {
                const unsigned c = corners[i];
                p[i] = ((z + (c >> 2)) * n + y + (c >> 1 & 1)) * n + x + (c & 1);
                inside |= values_[p[i]] < 0 ? 1U << i : 0U;
            }
            if (inside == 0 || inside == 15) continue;
            const auto& o = orders[inside];
            const auto edge = [&](unsigned from, unsigned to) { return corner(p[o[from]], p[o[to]]); };
            const int count = __builtin_popcount(inside);
            if (count == 2) {
                const std::uint32_t a = edge(0, 2), b = edge(0, 3), c = edge(1, 3), d = edge(1, 2);
                mesh_.triangles.push_back({a, b, c});
                mesh_.triangles.push_back({a, c, d});
            } else {
                const std::uint32_t a = edge(0, 1), b = edge(0, 2), c = edge(0, 3);
                mesh_.triangles.push_back(count == 1 ? std::array{a, b, c} : std::array{a, c, b});
            }
        }
    }

    /// Where the surface crosses an edge of the grid: the same numbers whichever way it runs.
    std::uint32_t corner(std::size_t from, std::size_t to) {
        const std::size_t i = std::min(from, to), k = std::max(from, to);
        const Vec3d p = point(i), w = point(k) - p;
        const BlobLine line(form_, p, w);
        mesh_.vertices.push_back(p + w * sign_change(line, 0, values_[i], 1, values_[k]));
        return static_cast<std::uint32_t>(mesh_.vertices.size() - 1);
    }

    const Form& form_;
    std::size_t cells_;
    std::vector<double> values_;
    TriangleMesh mesh_;
};

}  // namespace

TriangleMesh blob_mesh(const Form& form, int corners) { return BlobGrid(form, std::min(corners, most_cells)).mesh(); }

}  // namespace cardioid::csg
