#include "formats/mesh/write/mesh_formats.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <fmt/format.h>

#include "formats/mesh/write/scene_meshes.hpp"
#include "formats/mesh/write/three_mf_writer.hpp"

namespace cardioid::formats {
namespace {

/// The bytes of a value, the least first.
template <class T>
void append(std::string& out, T value) {
    auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
    if (std::endian::native == std::endian::big) std::reverse(bytes.begin(), bytes.end());
    out.append(bytes.data(), bytes.size());
}

MeshWish wish(const WriteOptions& options, bool one) {
    return {options.tolerance, one, options.notes, options.progress};
}

/// Single precision, as STL has it; triangles of which two corners become one are left out, which leaves no hole.
std::string write_stl(const Scene& scene, const WriteOptions& options) {
    const TriangleMesh mesh = std::move(scene_meshes(scene, wish(options, true))[0].mesh);
    std::string triangles;
    std::uint32_t count = 0;
    for (const auto& t : mesh.triangles) {
        std::array<Vec3, 3> p;
        for (std::size_t i = 0; i < 3; ++i) p[i] = Vec3(mesh.vertices[t[i]]);
        if (p[0] == p[1] || p[1] == p[2] || p[2] == p[0]) continue;
        const Vec3d a(p[0]), n = cross(Vec3d(p[1]) - a, Vec3d(p[2]) - a);
        const Vec3 normal = length(n) > 0 ? Vec3(normalize(n)) : Vec3{};
        for (const Vec3 v : {normal, p[0], p[1], p[2]})
            append(triangles, v.x), append(triangles, v.y), append(triangles, v.z);
        append(triangles, std::uint16_t{0});
        ++count;
    }
    constexpr std::size_t header = 80;
    std::string out = "cardioid " CARDIOID_VERSION;
    out.resize(header, ' ');
    append(out, count);
    return out + triangles;
}

std::string write_off(const Scene& scene, const WriteOptions& options) {
    const TriangleMesh mesh = std::move(scene_meshes(scene, wish(options, true))[0].mesh);
    std::string out = fmt::format("OFF\n{} {} 0\n", mesh.vertices.size(), mesh.triangles.size());
    for (const Vec3d v : mesh.vertices) out += fmt::format("{} {} {}\n", v.x, v.y, v.z);
    for (const auto& [a, b, c] : mesh.triangles) out += fmt::format("3 {} {} {}\n", a, b, c);
    return out;
}

std::string write_obj(const Scene& scene, const WriteOptions& options) {
    std::string out = "# cardioid " CARDIOID_VERSION "\n";
    std::size_t first = 1;
    for (const MeshPart& part : scene_meshes(scene, wish(options, false))) {
        out += fmt::format("o {}\nusemtl {}\n", part.name, part.material);
        for (const Vec3d v : part.mesh.vertices) out += fmt::format("v {} {} {}\n", v.x, v.y, v.z);
        for (const auto& [a, b, c] : part.mesh.triangles)
            out += fmt::format("f {} {} {}\n", first + a, first + b, first + c);
        first += part.mesh.vertices.size();
    }
    return out;
}

/// Doubles, so that nothing is lost; a face knows the number of its material, whose names stand in comments.
std::string write_ply(const Scene& scene, const WriteOptions& options) {
    const std::vector<MeshPart> parts = scene_meshes(scene, wish(options, false));
    std::string names, vertices, faces;
    std::size_t vertex_count = 0, face_count = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        names += fmt::format("comment material {} {}\n", i, parts[i].name);
        for (const Vec3d v : parts[i].mesh.vertices)
            append(vertices, v.x), append(vertices, v.y), append(vertices, v.z);
        for (const auto& t : parts[i].mesh.triangles) {
            append(faces, std::uint8_t{3});
            for (const std::uint32_t v : t) append(faces, static_cast<std::uint32_t>(vertex_count + v));
            append(faces, static_cast<std::uint32_t>(i));
        }
        vertex_count += parts[i].mesh.vertices.size(), face_count += parts[i].mesh.triangles.size();
    }
    return fmt::format(
               "ply\nformat binary_little_endian 1.0\ncomment cardioid {}\n{}element vertex {}\nproperty double x\n"
               "property double y\nproperty double z\nelement face {}\nproperty list uchar uint vertex_indices\n"
               "property uint material_index\nend_header\n",
               CARDIOID_VERSION, names, vertex_count, face_count) +
           vertices + faces;
}

std::string write_three_mf(const Scene& scene, const WriteOptions& options) {
    return three_mf_archive(scene_meshes(scene, wish(options, false)));
}

constexpr std::array stl_extensions = {".stl"};
constexpr std::array off_extensions = {".off"};
constexpr std::array obj_extensions = {".obj"};
constexpr std::array ply_extensions = {".ply"};
constexpr std::array three_mf_extensions = {".3mf"};

}  // namespace

const Format stl_format{"stl",    "what the scene encloses as one mesh, binary STL", stl_extensions, nullptr, nullptr,
                        write_stl};
const Format off_format{"off", "what the scene encloses as one mesh, OFF", off_extensions, nullptr, nullptr, write_off};
const Format obj_format{"obj", "a mesh a material, Wavefront OBJ", obj_extensions, nullptr, nullptr, write_obj};
const Format ply_format{"ply", "a mesh a material, binary PLY", ply_extensions, nullptr, nullptr, write_ply};
const Format three_mf_format{
    "3mf", "a mesh a material, 3MF in millimetres", three_mf_extensions, nullptr, nullptr, write_three_mf};

}  // namespace cardioid::formats
