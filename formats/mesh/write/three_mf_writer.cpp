#include "formats/mesh/write/three_mf_writer.hpp"

#include <fmt/format.h>

#include "formats/mesh/zip_archive.hpp"

namespace cardioid::formats {

namespace {

/// A text as an XML attribute's value.
std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '&')
            out += "&amp;";
        else if (c == '<')
            out += "&lt;";
        else if (c == '"')
            out += "&quot;";
        else
            out += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
    return out;
}

std::string object(const MeshPart& part, std::size_t id) {
    std::string out = fmt::format(R"(<object id="{}" type="model" name="{}"><mesh><vertices>)", id, escaped(part.name));
    for (const Vec3d v : part.mesh.vertices) out += fmt::format(R"(<vertex x="{}" y="{}" z="{}"/>)", v.x, v.y, v.z);
    out += "</vertices><triangles>";
    for (const auto& [a, b, c] : part.mesh.triangles)
        out += fmt::format(R"(<triangle v1="{}" v2="{}" v3="{}"/>)", a, b, c);
    return out + "</triangles></mesh></object>\n";
}

constexpr const char* xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";

std::string model(const std::vector<MeshPart>& parts) {
    std::string out = xml;
    out +=
        "<model unit=\"millimeter\" xml:lang=\"en-US\" "
        "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n<resources>\n";
    for (std::size_t i = 0; i < parts.size(); ++i) out += object(parts[i], i + 1);
    out += "</resources>\n<build>";
    for (std::size_t i = 0; i < parts.size(); ++i) out += fmt::format(R"(<item objectid="{}"/>)", i + 1);
    return out + "</build>\n</model>\n";
}

}  // namespace

std::string three_mf_archive(const std::vector<MeshPart>& parts) {
    const std::string types =
        std::string(xml) +
        "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">"
        "<Default Extension=\"rels\" ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>"
        "<Default Extension=\"model\" "
        "ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/></Types>\n";
    const std::string relations =
        std::string(xml) +
        "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\"><Relationship "
        "Target=\"/3D/3dmodel.model\" Id=\"rel0\" "
        "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>\n";
    return zip({{"[Content_Types].xml", types}, {"_rels/.rels", relations}, {"3D/3dmodel.model", model(parts)}});
}

}  // namespace cardioid::formats
