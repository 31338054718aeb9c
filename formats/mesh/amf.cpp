#include "formats/mesh/xml_mesh.hpp"
#include "formats/mesh/zip_archive.hpp"
#include "rt_core/api/error.hpp"

namespace cardioid::formats {

namespace {

std::uint32_t corner(const pugi::xml_node& triangle, const char* name, const std::string& file) {
    const double x = xml_number(triangle.child_value(name), file, "a vertex number");
    return x >= 0 && x < 0xFFFFFFFF ? static_cast<std::uint32_t>(x) : 0xFFFFFFFFU;
}

void add_object(const pugi::xml_node& object, const std::string& file, MeshBuilder& mesh) {
    for (const pugi::xml_node& part : object.children("mesh")) {
        std::vector<Vec3d> vertices;
        std::vector<std::array<std::uint32_t, 3>> triangles;
        for (const pugi::xml_node& vertex : part.child("vertices").children("vertex")) {
            const pugi::xml_node at = vertex.child("coordinates");
            const auto number = [&](const char* axis) {
                return xml_number(at.child_value(axis), file, "a coordinate");
            };
            vertices.push_back({number("x"), number("y"), number("z")});
        }
        for (const pugi::xml_node& volume : part.children("volume"))
            for (const pugi::xml_node& t : volume.children("triangle"))
                triangles.push_back({corner(t, "v1", file), corner(t, "v2", file), corner(t, "v3", file)});
        add_part(vertices, triangles, Affine{}, file, mesh);
    }
}

}  // namespace

void read_amf(const MeshText& text, MeshBuilder& mesh) {
    std::string unpacked;
    std::string_view xml = text.bytes;
    if (xml.starts_with("PK")) {
        const std::vector<ZipEntry> entries = zip_entries(xml, text.file);
        if (entries.empty()) throw Error(ErrorCode::bad_input, text.file + ": found an empty archive, wanted an AMF");
        unpacked = unzip(xml, entries[0], text.file);
        xml = unpacked;
    }
    pugi::xml_document document;
    parse_xml(xml, text.file, document);
    const pugi::xml_node amf = document.child("amf");
    if (!amf) throw Error(ErrorCode::bad_input, text.file + ":1: found no <amf>, wanted an AMF");
    for (const pugi::xml_node& object : amf.children("object")) add_object(object, text.file, mesh);
}

}  // namespace cardioid::formats
