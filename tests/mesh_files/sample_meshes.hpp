#pragma once
#include <algorithm>
#include <bit>
#include <cstdint>
#include <string>

#include "csg/shapes/facets.hpp"

namespace cardioid::test {

/// The bytes of a value in either order.
template <class T>
std::string bytes_of(T value, std::endian order = std::endian::little) {
    std::string out(sizeof(T), '\0');
    std::copy_n(reinterpret_cast<const char*>(&value), sizeof(T), out.begin());
    if (order != std::endian::native) std::ranges::reverse(out);
    return out;
}

inline std::string binary_stl(const TriangleMesh& mesh, const std::string& title, std::uint32_t count) {
    std::string out = title;
    out.resize(80, ' ');
    out += bytes_of(count);
    for (const auto& t : mesh.triangles) {
        out += std::string(12, '\0');
        for (const std::uint32_t v : t)
            for (int axis = 0; axis < 3; ++axis) out += bytes_of(static_cast<float>(mesh.vertices[v][axis]));
        out += std::string(2, '\0');
    }
    return out;
}

inline std::string binary_stl(const TriangleMesh& mesh, const std::string& title = "made for a test") {
    return binary_stl(mesh, title, static_cast<std::uint32_t>(mesh.triangles.size()));
}

inline std::string ascii_stl(const TriangleMesh& mesh) {
    std::string out = "solid sample with a name\n";
    for (const auto& t : mesh.triangles) {
        out += "  facet normal 0 0 nan\n    outer loop\n";
        for (const std::uint32_t v : t) {
            out += "      vertex";
            for (int axis = 0; axis < 3; ++axis) out.append(" ").append(std::to_string(mesh.vertices[v][axis]));
            out += "\n";
        }
        out += "    endloop\n  endfacet\n";
    }
    return out + "endsolid sample with a name\n";
}

/// A unit cube of quads, with what else PLY files carry: normals, colours, an unknown element.
inline std::string ply_cube(const std::string& format, const std::string& faces = "6") {
    std::string out = "ply\nformat " + format +
                      " 1.0\ncomment made for a test\nelement material 2\nproperty uchar shade\n" +
                      "property list uchar short more\nelement vertex 8\nproperty float x\nproperty double y\n" +
                      "property float nx\nproperty short z\nelement face " + faces +
                      "\nproperty uchar flags\nproperty list uchar int vertex_indices\nend_header\n";
    const int quads[6][4] = {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
    const bool ascii = format == "ascii";
    const std::endian order = format == "binary_big_endian" ? std::endian::big : std::endian::little;
    const auto add = [&](auto value) { out += ascii ? std::to_string(value) + " " : bytes_of(value, order); };
    const auto end_line = [&] { out += ascii ? "\n" : ""; };
    for (const int shade : {10, 13}) {
        add(static_cast<std::uint8_t>(shade)), add(std::uint8_t{2}), add(std::int16_t{-1}), add(std::int16_t{7});
        end_line();
    }
    for (int i = 0; i < 8; ++i) {
        add(i % 4 == 1 || i % 4 == 2 ? 1.0F : 0.0F), add(i % 4 >= 2 ? 1.0 : 0.0), add(0.5F);
        add(static_cast<std::int16_t>(i / 4));
        end_line();
    }
    for (const auto& quad : quads) {
        add(std::uint8_t{9}), add(std::uint8_t{4});
        for (const int v : quad) add(v);
        end_line();
    }
    return out;
}

}  // namespace cardioid::test
