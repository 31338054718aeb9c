#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "formats/mesh/gltf_buffers.hpp"
#include "formats/mesh/xml_mesh.hpp"
#include "rt_core/api/error.hpp"

namespace cardioid::formats {

namespace {

using Json = nlohmann::json;

Affine rotation(double x, double y, double z, double w) {
    return {{Vec3d{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
             {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
             {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}},
            {}};
}

Affine map_of(const Json& node) {
    if (node.contains("matrix")) {
        const auto m = node["matrix"].get<std::vector<double>>();
        if (m.size() != 16) throw Error(ErrorCode::bad_input, "found a matrix of other than 16 numbers");
        return {{Vec3d{m[0], m[4], m[8]}, {m[1], m[5], m[9]}, {m[2], m[6], m[10]}}, {m[12], m[13], m[14]}};
    }
    Affine out;
    if (node.contains("translation")) {
        const Json& t = node["translation"];
        out = Affine::translation({t.at(0), t.at(1), t.at(2)});
    }
    if (node.contains("rotation")) {
        const Json& q = node["rotation"];
        out = out * rotation(q.at(0), q.at(1), q.at(2), q.at(3));
    }
    if (node.contains("scale")) {
        const Json& s = node["scale"];
        out = out * Affine::scaling({s.at(0), s.at(1), s.at(2)});
    }
    return out;
}

/// The meshes of a scene's nodes.
class Reader {
public:
    Reader(const Json& root, const GltfBuffers& buffers, const std::string& file, MeshBuilder& mesh)
        : root_(root), buffers_(buffers), file_(file), mesh_(mesh) {
        const Affine z_up{{Vec3d{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}, {}};
        const std::size_t scene = root.value("scene", std::size_t{0});
        for (const Json& node : root.at("scenes").at(scene).value("nodes", Json::array())) place(node, z_up, 0);
    }

private:
    void place(const Json& index, const Affine& outer, int depth) {
        constexpr int deepest = 1000;
        if (depth > deepest) throw Error(ErrorCode::bad_input, file_ + ": found a node within itself");
        constexpr int most = 1'000'000;  // of a few nodes each may have two of the next
        if (++placed_ > most) throw Error(ErrorCode::limit, file_ + ": found more than a million nodes");
        const Json& node = root_.at("nodes").at(index.get<std::size_t>());
        const Affine map = outer * map_of(node);
        for (const Json& child : node.value("children", Json::array())) place(child, map, depth + 1);
        if (!node.contains("mesh")) return;
        for (const Json& part : root_.at("meshes").at(node["mesh"].get<std::size_t>()).at("primitives")) add(part, map);
    }

    /// Triangles, strips and fans; points and lines are no solid.
    void add(const Json& part, const Affine& map) {
        constexpr int list = 4, strip = 5, fan = 6;
        const int mode = part.value("mode", list);
        if (mode != list && mode != strip && mode != fan) return;
        const std::vector<Vec3d> vertices = buffers_.vectors(part.at("attributes").at("POSITION").get<std::size_t>());
        std::vector<std::uint32_t> corners;
        if (part.contains("indices"))
            corners = buffers_.indices(part["indices"].get<std::size_t>());
        else
            for (std::uint32_t i = 0; i < vertices.size(); ++i) corners.push_back(i);
        std::vector<std::array<std::uint32_t, 3>> triangles;
        for (std::size_t i = 0; i + 2 < corners.size(); i += mode == list ? 3 : 1) {
            const std::uint32_t a = mode == fan ? corners[0] : corners[i], b = corners[i + 1], c = corners[i + 2];
            const bool turned = mode == strip && i % 2 == 1;
            triangles.push_back({a, turned ? c : b, turned ? b : c});
        }
        add_part(vertices, triangles, map, file_, mesh_);
    }

    const Json& root_;
    const GltfBuffers& buffers_;
    const std::string& file_;
    MeshBuilder& mesh_;
    int placed_ = 0;
};

}  // namespace

void read_gltf(const MeshText& text, MeshBuilder& mesh) try {
    const GltfParts parts = split_gltf(text.bytes, text.file);
    const Json root = Json::parse(parts.json);
    const GltfBuffers buffers(root, parts.binary, text.file);
    const Reader reader(root, buffers, text.file, mesh);
} catch (const std::out_of_range& e) {
    throw Error(ErrorCode::bad_input, text.file + ": no glTF: " + e.what());
} catch (const Json::exception& e) {
    throw Error(ErrorCode::bad_input, text.file + ": no glTF: " + e.what());
}

}  // namespace cardioid::formats
