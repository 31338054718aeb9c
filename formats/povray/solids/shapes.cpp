#include "formats/povray/solids/shapes.hpp"

#include <fmt/format.h>

#include "csg/exact/tessellate.hpp"
#include "formats/povray/scene/sdl.hpp"

namespace cardioid::formats::povray {

namespace {

/// Six digits of a rotation in the file leave axes this far from square.
constexpr double square = 1e-9;
/// Chords of shapes that POV-Ray has no word for stay within this share of their size.
constexpr double mesh_share = 1e-3;
/// Rays from inside a mesh go along this to tell that they are: no edge of a model is likely to lie on it.
constexpr const char* inside_vector = "<0.5377, 0.2143, 0.8155>";

bool axes_parallel(const Affine& m) {
    const auto off = [&](std::size_t row, int a, int b) { return m.row[row][a] == 0 && m.row[row][b] == 0; };
    return off(0, 1, 2) && off(1, 0, 2) && off(2, 0, 1);
}

/// The length that two columns share where they stand at right angles and are equally long, else 0.
double common_length(const Affine& m, int a, int b) {
    const Vec3d u = m.column(a), v = m.column(b);
    const double uu = dot(u, u), vv = dot(v, v);
    const bool fits = std::abs(uu - vv) <= square * uu && std::abs(dot(u, v)) <= square * uu;
    return fits ? std::sqrt(uu) : 0;
}

bool at_right_angles(Vec3d u, Vec3d v) { return std::abs(dot(u, v)) <= square * length(u) * length(v); }

Affine scaled(const Affine& m, double scale) {
    Affine out = m;
    for (Vec3d& row : out.row) row *= scale;
    out.t *= scale;
    return out;
}

std::string box(const Affine& m) {
    if (!axes_parallel(m)) return fmt::format("box {{ 0, 1 {}", sdl(m));
    const Vec3d end = m.point({1, 1, 1});
    return fmt::format("box {{ {}, {}", sdl(min(m.t, end)), sdl(max(m.t, end)));
}

std::string sphere(const Affine& m) {
    const double r = common_length(m, 0, 1);
    if (r > 0 && common_length(m, 1, 2) > 0 && common_length(m, 0, 2) > 0)
        return fmt::format("sphere {{ {}, {}", sdl(m.t), sdl(r));
    return fmt::format("sphere {{ 0, 1 {}", sdl(m));
}

std::string cone(const Leaf& leaf, const Affine& m) {
    const double width = common_length(m, 0, 1);
    const Vec3d axis = m.column(2);
    const bool upright = width > 0 && at_right_angles(m.column(0), axis) && at_right_angles(m.column(1), axis);
    const double times = upright ? width : 1;
    const std::string base = upright ? sdl(m.t) : "0", cap = upright ? sdl(m.t + axis) : "z";
    const std::string place = upright ? "" : fmt::format(" {}", sdl(m));
    if (leaf.a == leaf.b) return fmt::format("cylinder {{ {}, {}, {}{}", base, cap, sdl(leaf.a * times), place);
    return fmt::format("cone {{ {}, {}, {}, {}{}", base, sdl(leaf.a * times), cap, sdl(leaf.b * times), place);
}

/// POV-Ray's shapes of revolution and its prisms stand along y: local x, y, z of ours are its x, z, y.
Affine from_upright() { return {{Vec3d{1, 0, 0}, {0, 0, 1}, {0, 1, 0}}, {}}; }

/// POV-Ray's root finder wants tori of ordinary size, so scale goes into the radii and not into the matrix.
std::string torus(const Leaf& leaf, Affine m) {
    const double size = std::cbrt(std::abs(m.determinant()));
    for (Vec3d& row : m.row) row *= 1 / size;
    return fmt::format("torus {{ {}, {} {}", sdl(leaf.a * size), sdl(leaf.b * size), sdl(m * from_upright()));
}

std::string half_space(const Affine& m) {
    const Vec3d normal = normalize(cross(m.column(0), m.column(1)) * (m.determinant() > 0 ? 1.0 : -1.0));
    return fmt::format("plane {{ {}, {}", sdl(normal), sdl(dot(normal, m.t)));
}

/// Every contour as a closed list of `<x, y>`.
std::string points(const Profile& profile, std::size_t& count) {
    std::string text;
    count = 0;
    for (const auto& contour : profile.contours)
        for (std::size_t i = 0; i <= contour.size(); ++i) {
            const Vec2d p = contour[i % contour.size()];
            text += fmt::format(", <{}, {}>", sdl(p.x), sdl(p.y));
            ++count;
        }
    return text;
}

std::string prism(const Leaf& leaf, const Profile& profile, const Affine& m) {
    std::size_t count = 0;
    const std::string list = points(profile, count);
    if (leaf.a == 1)
        return fmt::format("prism {{ linear_sweep linear_spline 0, 1, {}{} {}", count, list, sdl(m * from_upright()));
    // A conic prism has its tip at y = 0 and its contours' own size at y = 1; ours is 1 + (a - 1) z times as large.
    const double lean = 1 / (leaf.a - 1);
    const Affine from_cone{{Vec3d{1, 0, 0}, {0, 0, 1}, {0, lean, 0}}, {0, 0, -lean}};
    return fmt::format("prism {{ conic_sweep linear_spline {}, {}, {}{} {}", sdl(std::min(1.0, leaf.a)),
                       sdl(std::max(1.0, leaf.a)), count, list, sdl(m * from_cone));
}

double area(const std::vector<Vec2d>& contour) {
    double sum = 0;
    for (std::size_t i = 0; i < contour.size(); ++i) sum += cross(contour[i], contour[(i + 1) % contour.size()]);
    return sum / 2;
}

/// A lathe has one contour; others are put to it or taken out of it by which way they run.
std::string revolution(const Profile& profile, const Affine& m) {
    std::string parts, holes;
    for (const auto& contour : profile.contours) {
        std::size_t count = 0;
        const std::string list = points({{contour}}, count);
        (area(contour) > 0 ? parts : holes) += fmt::format("lathe {{ linear_spline {}{} }} ", count, list);
    }
    const std::string place = sdl(m * from_upright());
    if (profile.contours.size() == 1) return (parts + holes).substr(0, (parts + holes).size() - 2) + place;
    if (holes.empty()) return fmt::format("union {{ {}{}", parts, place);
    return fmt::format("difference {{ union {{ {}}} {}{}", parts, holes, place);
}

std::string mesh(const TriangleMesh& mesh, const Affine& m) {
    std::string text = fmt::format("mesh2 {{ vertex_vectors {{ {}", mesh.vertices.size());
    for (const Vec3d& p : mesh.vertices) text += ",\n" + sdl(m.point(p));
    text += fmt::format(" }}\nface_indices {{ {}", mesh.triangles.size());
    for (const auto& t : mesh.triangles) text += fmt::format(",\n<{}, {}, {}>", t[0], t[1], t[2]);
    return text + fmt::format(" }}\ninside_vector {}", inside_vector);
}

}  // namespace

std::string shape(const Leaf& given, const SolidTree& solids, double scale, const Growth& growth) {
    const Leaf leaf = growth.none() ? given : grown(given, solids, scale, growth);
    const Affine m = scaled(leaf.to_world, scale);
    switch (leaf.kind) {
        case LeafKind::box:
            return box(m);
        case LeafKind::sphere:
            return sphere(m);
        case LeafKind::cone:
            return cone(leaf, m);
        case LeafKind::torus:
            return torus(leaf, m);
        case LeafKind::half_space:
            return half_space(m);
        case LeafKind::prism:
            return prism(leaf, *solids.profiles[leaf.data], m);
        case LeafKind::revolution:
            return revolution(*solids.profiles[leaf.data], m);
        case LeafKind::mesh:
            return mesh(*solids.meshes[leaf.data], m);
        case LeafKind::form: {
            const double size = csg::tight_bounds(solids, leaf).diagonal();
            return mesh(csg::tessellate(solids, leaf, mesh_share * size), Affine::scaling({scale, scale, scale}));
        }
    }
    return "";
}

}  // namespace cardioid::formats::povray
