#include <algorithm>
#include <cmath>

#include "csg/shapes/mesh_repair.hpp"
#include "formats/openscad/geometry/solids.hpp"

namespace cardioid::formats::openscad {
namespace {

/// The corners; NaN where one is not three numbers.
std::vector<Vec3d> read_points(const Arguments& args) {
    const Value* list = args.value("points");
    if (!list) return {};
    if (list->kind != ValueKind::list && list->kind != ValueKind::numbers && list->kind != ValueKind::range)
        args.wrong("points", "a list of points [x, y, z]");
    std::vector<Vec3d> out;
    if (list->kind != ValueKind::list) return out;
    const auto rows = args.ast().values_of(*list);
    out.reserve(rows.size());
    for (const Value& row : rows) {
        Vec3d p{NAN, NAN, NAN};
        if (row.kind == ValueKind::numbers && row.count >= 3) {
            const auto xs = args.ast().numbers_of(row);
            p = {xs[0], xs[1], xs[2]};
        }
        out.push_back(p);
    }
    return out;
}

constexpr std::uint32_t bad_index = 0xFFFFFFFFU;  // beyond every list of points: the face is left out and counted

std::uint32_t index_of(double x, const std::vector<Vec3d>& points) {
    if (!(x >= 0 && x < static_cast<double>(points.size()))) return bad_index;
    return static_cast<std::uint32_t>(x);
}

/// A face given as the range [a : b] or [a : step : b].
std::vector<std::uint32_t> range_face(std::span<const Value> ends, const Arguments& args,
                                      const std::vector<Vec3d>& points) {
    double x[3] = {0, 0, 0};
    for (std::size_t i = 0; i < ends.size(); ++i) {
        if (ends[i].kind != ValueKind::number) return {bad_index};
        x[i] = args.ast().numbers[ends[i].first];
    }
    const double begin = x[0], step = ends.size() == 3 ? x[1] : 1, end = x[ends.size() - 1];
    const double steps = std::floor((end - begin) / step);
    if (!(steps >= 0 && steps < static_cast<double>(points.size()))) return {bad_index};
    std::vector<std::uint32_t> out;
    for (double i = 0; i <= steps; ++i) out.push_back(index_of(begin + i * step, points));
    return out;
}

std::vector<std::vector<std::uint32_t>> read_faces(const Arguments& args, const std::vector<Vec3d>& points) {
    const Value* list = args.value("faces");
    if (!list) list = args.value("triangles");
    std::vector<std::vector<std::uint32_t>> out;
    if (!list || list->kind != ValueKind::list) return out;
    const auto rows = args.ast().values_of(*list);
    out.reserve(rows.size());
    for (const Value& row : rows) {
        std::vector<std::uint32_t> face;
        if (row.kind == ValueKind::numbers) {
            face.reserve(row.count);
            for (const double x : args.ast().numbers_of(row)) face.push_back(index_of(x, points));
        } else if (row.kind == ValueKind::range) {
            face = range_face(args.ast().values_of(row), args, points);
        } else {
            face = {bad_index};
        }
        out.push_back(std::move(face));
    }
    return out;
}

}  // namespace

std::optional<Shape> make_polyhedron(const Arguments& args, ShapeContext& context) {
    const std::vector<Vec3d> points = read_points(args);
    if (!std::all_of(points.begin(), points.end(), [](Vec3d p) { return is_finite(p); })) {
        context.warnings.add(args.where(), "a point of the polyhedron is not three finite numbers: removed");
        return std::nullopt;
    }
    const auto faces = read_faces(args, points);
    csg::MeshFaults faults;
    TriangleMesh mesh = csg::triangulate_polyhedron(points, faces, faults);
    if (faults.dropped_faces > 0)
        context.warnings.add(
            args.where(), std::to_string(faults.dropped_faces) + " faces of the polyhedron have bad corners: left out");
    if (faults.non_planar_faces > 0)
        context.warnings.add(args.where(), std::to_string(faults.non_planar_faces) +
                                               " faces of the polyhedron are not flat: the solid depends on how they "
                                               "are cut into triangles");
    return make_mesh(std::move(mesh), args.where(), context);
}

}  // namespace cardioid::formats::openscad
