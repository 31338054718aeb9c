#include "csg/leaves/mesh_shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace cardioid::csg {
namespace {

/// The line in a frame where it runs along z through the origin: a vertex v goes to (x - shear_x z, y - shear_y z, z /
/// d_z).
struct Shear {
    int kx, ky, kz;
    double shear_x, shear_y, inverse_dz;
    Vec3d o;

    Shear(Vec3d origin, Vec3d d) : o(origin) {
        const Vec3d a = abs(d);
        kz = a.x > a.y ? (a.x > a.z ? 0 : 2) : (a.y > a.z ? 1 : 2);
        kx = (kz + 1) % 3, ky = (kz + 2) % 3;
        shear_x = d[kx] / d[kz], shear_y = d[ky] / d[kz], inverse_dz = 1 / d[kz];
    }
    [[nodiscard]] Vec3d operator()(Vec3d vertex) const {
        const Vec3d v = vertex - o;
        return {v[kx] - shear_x * v[kz], v[ky] - shear_y * v[kz], v[kz] * inverse_dz};
    }
};

/// Sign of ax by - bx ay: exact, so that an edge says the same to both its triangles.
double cross_sign(double ax, double ay, double bx, double by) {
    const double p = ax * by, q = bx * ay;
    const double difference = p - q;
    if (std::abs(difference) > 1e-15 * (std::abs(p) + std::abs(q))) return difference;
    return difference + (std::fma(ax, by, -p) - std::fma(bx, ay, -q));
}

/// Whether the edge a-b crosses the positive x axis; an end on the axis counts as below it.
bool crosses(const Vec3d& a, const Vec3d& b) {
    if ((a.y > 0) == (b.y > 0)) return false;
    const double sign = cross_sign(a.x, a.y, b.x, b.y);
    return b.y > a.y ? sign > 0 : sign < 0;
}

/// Distance along the line to the plane of the triangle, kept within its corners.
double plane_distance(const std::array<Vec3d, 3>& v) {
    const Vec3d n = cross(v[1] - v[0], v[2] - v[0]);
    const auto [lo, hi] = std::minmax({v[0].z, v[1].z, v[2].z});
    if (n.z == 0) return 0.5 * (lo + hi);
    return std::clamp(v[0].z + (n.x * v[0].x + n.y * v[0].y) / n.z, lo, hi);
}

}  // namespace

MeshShape::MeshShape(std::shared_ptr<const TriangleMesh> mesh) : mesh_(std::move(mesh)) {
    std::vector<Box3d> boxes(mesh_->triangles.size());
    for (std::size_t i = 0; i < boxes.size(); ++i)
        for (const std::uint32_t corner : mesh_->triangles[i]) boxes[i].include(mesh_->vertices[corner]);
    bvh_ = Bvh8(boxes, 4);
}

void MeshShape::append_events(std::uint32_t index, Vec3d o, Vec3d d, EventList& out) const {
    if (bvh_.empty()) return;
    const std::size_t first = out.size();
    const double speed = length(d);
    const Vec3d unit = d * (1 / speed);
    const Vec3d near = o + unit * dot(bvh_.centre() - o, unit) - bvh_.centre();
    const BoxRay box_ray{Vec3(near), Vec3(unit)};
    const Shear shear(o, d);
    constexpr float everywhere = std::numeric_limits<float>::max();
    alignas(32) float entry[8];
    thread_local std::vector<std::uint32_t> stack;
    stack.assign(1, 0);
    while (!stack.empty()) {
        const BvhNode& node = bvh_.node(stack.back());
        stack.pop_back();
        for (unsigned mask = hit_boxes(node, box_ray, -everywhere, everywhere, entry); mask; mask &= mask - 1) {
            const std::uint32_t child = node.child[static_cast<unsigned>(__builtin_ctz(mask))];
            if (!(child & Bvh8::leaf_flag)) {
                stack.push_back(child);
                continue;
            }
            const std::uint32_t begin = (child & ~Bvh8::leaf_flag) >> 3, count = child & 7;
            for (std::uint32_t i = begin; i < begin + count; ++i) {
                const std::uint32_t face = bvh_.order()[i];
                const auto& corners = mesh_->triangles[face];
                const std::array<Vec3d, 3> v{shear(mesh_->vertices[corners[0]]), shear(mesh_->vertices[corners[1]]),
                                             shear(mesh_->vertices[corners[2]])};
                if ((crosses(v[0], v[1]) != crosses(v[1], v[2])) == crosses(v[2], v[0])) continue;
                out.push_back(make_event(plane_distance(v), index, face, false));
            }
        }
    }
    std::sort(out.begin() + static_cast<std::ptrdiff_t>(first), out.end(),
              [](const Event& a, const Event& b) { return a.t < b.t || (a.t == b.t && a.face < b.face); });
    if ((out.size() - first) % 2 != 0) out.pop_back();  // only an open mesh comes here
    for (std::size_t i = first; i < out.size(); ++i) out[i].entering = (i - first) % 2 == 0;
}

Vec3d MeshShape::normal(std::uint32_t face) const {
    const auto& [a, b, c] = mesh_->triangles[face];
    return cross(mesh_->vertices[b] - mesh_->vertices[a], mesh_->vertices[c] - mesh_->vertices[a]);
}

std::size_t MeshShape::memory_bytes() const noexcept {
    return bvh_.memory_bytes() + mesh_->vertices.capacity() * sizeof(Vec3d) + mesh_->triangles.capacity() * 12;
}

}  // namespace cardioid::csg
