#include <algorithm>
#include <map>

#include "formats/mesh/text_cursor.hpp"
#include "formats/mesh/xml_mesh.hpp"
#include "formats/mesh/zip_archive.hpp"
#include "rt_core/api/error.hpp"

namespace cardioid::formats {

namespace {

double unit_in_mm(const std::string& unit) {
    return unit == "inch"         ? 25.4
           : unit == "meter"      ? 1000
           : unit == "foot"       ? 304.8
           : unit == "centimeter" ? 10
           : unit == "micron"     ? 1e-3
                                  : 1;
}

/// The objects of a 3MF model, placed.
class Model {
public:
    Model(const pugi::xml_node& model, const std::string& file, MeshBuilder& mesh) : file_(file), mesh_(mesh) {
        for (const pugi::xml_node& object : model.child("resources").children("object"))
            objects_[object.attribute("id").value()] = object;
        const double scale = unit_in_mm(model.attribute("unit").value());
        const Affine to_mm = Affine::scaling({scale, scale, scale});
        for (const pugi::xml_node& item : model.child("build").children("item"))
            place(item.attribute("objectid").value(), to_mm * map_of(item), 0);
    }

private:
    /// "m00 m01 m02 m10 ... m32": a row vector times this matrix.
    [[nodiscard]] Affine map_of(const pugi::xml_node& node) const {
        const pugi::xml_attribute given = node.attribute("transform");
        Affine out;
        if (!given) return out;
        TextCursor in(given.value(), file_);
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) out.row[static_cast<std::size_t>(j)][i] = in.number();
        for (int j = 0; j < 3; ++j) out.t[j] = in.number();
        return out;
    }

    void place(const std::string& id, const Affine& map, int depth) {
        constexpr int deepest = 100;
        const auto object = objects_.find(id);
        if (object == objects_.end())
            throw Error(ErrorCode::bad_input, file_ + ": found object " + quoted(id) + " that is not there");
        if (depth > deepest) throw Error(ErrorCode::bad_input, file_ + ": found an object within itself");
        constexpr int most = 1'000'000;  // of a few components each are two of the next
        if (++placed_ > most) throw Error(ErrorCode::limit, file_ + ": found more than a million components");
        for (const pugi::xml_node& part : object->second.child("components").children("component"))
            place(part.attribute("objectid").value(), map * map_of(part), depth + 1);
        if (const pugi::xml_node mesh = object->second.child("mesh")) add(mesh, map);
    }

    void add(const pugi::xml_node& mesh, const Affine& map) {
        std::vector<Vec3d> vertices;
        std::vector<std::array<std::uint32_t, 3>> triangles;
        for (const pugi::xml_node& v : mesh.child("vertices").children("vertex")) {
            const auto number = [&](const char* axis) {
                return xml_number(v.attribute(axis).value(), file_, "a coordinate");
            };
            vertices.push_back({number("x"), number("y"), number("z")});
        }
        for (const pugi::xml_node& t : mesh.child("triangles").children("triangle"))
            triangles.push_back(
                {t.attribute("v1").as_uint(), t.attribute("v2").as_uint(), t.attribute("v3").as_uint()});
        add_part(vertices, triangles, map, file_, mesh_);
    }

    const std::string& file_;
    MeshBuilder& mesh_;
    std::map<std::string, pugi::xml_node> objects_;
    int placed_ = 0;
};

}  // namespace

void read_3mf(const MeshText& text, MeshBuilder& mesh) {
    const std::vector<ZipEntry> entries = zip_entries(text.bytes, text.file);
    const auto entry = std::ranges::find_if(entries, [](const ZipEntry& e) { return e.name.ends_with(".model"); });
    if (entry == entries.end())
        throw Error(ErrorCode::bad_input, text.file + ": found an archive without a model, wanted a 3MF");
    const std::string xml = unzip(text.bytes, *entry, text.file);
    pugi::xml_document document;
    parse_xml(xml, text.file, document);
    const Model model(document.child("model"), text.file, mesh);
}

}  // namespace cardioid::formats
