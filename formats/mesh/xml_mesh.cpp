#include "formats/mesh/xml_mesh.hpp"

#include <algorithm>

#include "formats/mesh/text_cursor.hpp"
#include "rt_core/api/error.hpp"

namespace cardioid::formats {

void parse_xml(std::string_view text, const std::string& file, pugi::xml_document& out) {
    const pugi::xml_parse_result result = out.load_buffer(text.data(), text.size());
    if (result) return;
    const auto at = static_cast<std::size_t>(std::max<std::ptrdiff_t>(result.offset, 0));
    const auto line = 1 + std::ranges::count(text.substr(0, std::min(at, text.size())), '\n');
    throw Error(ErrorCode::bad_input, file + ":" + std::to_string(line) + ": no XML: " + result.description());
}

double xml_number(const char* text, const std::string& file, const char* wanted) {
    return TextCursor(text, file).number(TextCursor(text, file).word(), wanted);
}

void add_part(const std::vector<Vec3d>& vertices, const std::vector<std::array<std::uint32_t, 3>>& triangles,
              const Affine& map, const std::string& file, MeshBuilder& mesh) {
    constexpr std::size_t most = 100'000'000;  // a part may be placed again and again
    if (mesh.vertex_count() + vertices.size() > most)
        throw Error(ErrorCode::limit, file + ": found parts of more than a hundred million corners");
    const auto first = static_cast<std::uint32_t>(mesh.vertex_count());
    for (const Vec3d v : vertices) mesh.add_vertex(map.point(v));
    const bool mirrored = map.determinant() < 0;
    for (const auto& [a, b, c] : triangles) {
        if (std::max({a, b, c}) >= vertices.size())
            throw Error(ErrorCode::bad_input, file + ": found corner " + std::to_string(std::max({a, b, c})) +
                                                  ", wanted one of the mesh's " + std::to_string(vertices.size()));
        const std::array<std::uint32_t, 3> face{first + a, first + (mirrored ? c : b), first + (mirrored ? b : c)};
        mesh.add_face(face);
    }
}

}  // namespace cardioid::formats
