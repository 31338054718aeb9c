#pragma once
#include <array>

#include "rt_core/math/box.hpp"
#include "rt_core/math/vec.hpp"

namespace cardioid {

/// An affine map x -> A x + t; rows of A are `row[i]`, the translation is `t`.
struct Affine {
    std::array<Vec3d, 3> row{Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}};
    Vec3d t;

    constexpr bool operator==(const Affine&) const = default;

    static Affine translation(Vec3d by) { return {{Vec3d{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, by}; }
    static Affine scaling(Vec3d by) { return {{Vec3d{by.x, 0, 0}, {0, by.y, 0}, {0, 0, by.z}}, {}}; }

    [[nodiscard]] Vec3d vector(Vec3d v) const { return {dot(row[0], v), dot(row[1], v), dot(row[2], v)}; }
    [[nodiscard]] Vec3d point(Vec3d p) const { return vector(p) + t; }
    /// A-transposed times v: carries a normal of local space to the world when *this maps world to local.
    [[nodiscard]] Vec3d transposed_vector(Vec3d v) const { return row[0] * v.x + row[1] * v.y + row[2] * v.z; }
    [[nodiscard]] Vec3d column(int i) const { return {row[0][i], row[1][i], row[2][i]}; }
    [[nodiscard]] double determinant() const { return dot(row[0], cross(row[1], row[2])); }
    /// (*this)(inner(x)).
    [[nodiscard]] Affine operator*(const Affine& inner) const {
        Affine out;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                out.row[static_cast<std::size_t>(i)][j] = dot(row[static_cast<std::size_t>(i)], inner.column(j));
        out.t = point(inner.t);
        return out;
    }
    /// The determinant must not be zero.
    [[nodiscard]] Affine inverse() const {
        const double f = 1 / determinant();
        const Vec3d c0 = cross(row[1], row[2]) * f, c1 = cross(row[2], row[0]) * f, c2 = cross(row[0], row[1]) * f;
        Affine out;
        out.row = {Vec3d{c0.x, c1.x, c2.x}, {c0.y, c1.y, c2.y}, {c0.z, c1.z, c2.z}};
        out.t = -out.vector(t);
        return out;
    }
    /// The smallest axis-parallel box around the image of a bounded box.
    [[nodiscard]] Box3d box(const Box3d& b) const {
        Box3d out;
        for (int i = 0; i < 8; ++i)
            out.include(point({i & 1 ? b.hi.x : b.lo.x, i & 2 ? b.hi.y : b.lo.y, i & 4 ? b.hi.z : b.lo.z}));
        return out;
    }
};

}  // namespace cardioid
