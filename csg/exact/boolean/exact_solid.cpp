#include "csg/exact/boolean/exact_solid.hpp"

#include <algorithm>
#include <numeric>

#include "csg/exact/boolean/exact_data.hpp"
#include "csg/exact/boolean/flat_triangles.hpp"
#include "csg/shapes/mesh_repair.hpp"

namespace cardioid::csg {

namespace {

Vec3d nearest(const ExactPoint& p) {
    const auto& exact = CGAL::exact(p);
    return {CGAL::to_double(exact.x()), CGAL::to_double(exact.y()), CGAL::to_double(exact.z())};
}

}  // namespace

bool ExactData::settle() {
    std::vector<Vec3d> near;
    near.reserve(points.size());
    for (const ExactPoint& p : points) {
        const Vec3d v = nearest(p);
        near.push_back(v);
        const auto reach = p.bbox();
        box.include(Vec3d{reach.xmin(), reach.ymin(), reach.zmin()});
        box.include(Vec3d{reach.xmax(), reach.ymax(), reach.zmax()});
    }
    std::vector<std::uint32_t> order(points.size());
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) {
        const std::array p{near[a].x, near[a].y, near[a].z}, q{near[b].x, near[b].y, near[b].z};
        return p != q ? p < q : points[a] < points[b];
    });
    put_in_order(order);
    return std::ranges::adjacent_find(points) == points.end();
}

void ExactData::put_in_order(const std::vector<std::uint32_t>& order) {
    std::vector<ExactPoint> sorted;
    std::vector<std::uint32_t> number(points.size());
    for (const std::uint32_t i : order) {
        number[i] = static_cast<std::uint32_t>(sorted.size());
        sorted.push_back(points[i]);
    }
    points = std::move(sorted);
    for (auto& triangle : triangles) {
        for (std::uint32_t& v : triangle) v = number[v];
        std::ranges::rotate(triangle, std::ranges::min_element(triangle));
    }
    std::ranges::sort(triangles);
}

ExactSolid::ExactSolid(const TriangleMesh& mesh) {
    if (mesh.triangles.empty()) return;
    auto data = std::make_shared<ExactData>();
    for (const Vec3d v : mesh.vertices) data->points.emplace_back(v.x, v.y, v.z);
    data->triangles = mesh.triangles;
    turn_flat_triangles(data->points, data->triangles);
    if (data->triangles.empty()) return;
    data->settle();
    data->plain = true;
    data_ = std::move(data);
}

bool ExactSolid::is_plain() const { return !data_ || data_->plain; }

Box3d ExactSolid::bounds() const { return data_ ? data_->box : Box3d{}; }

TriangleMesh ExactSolid::rounded() const {
    TriangleMesh out;
    if (!data_) return out;
    for (const ExactPoint& p : data_->points) out.vertices.push_back(nearest(p));
    out.triangles = data_->triangles;
    weld(out);
    return out;
}

}  // namespace cardioid::csg
