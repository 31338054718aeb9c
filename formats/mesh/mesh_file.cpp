#include "formats/mesh/mesh_file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "formats/mesh/readers.hpp"
#include "rt_core/api/error.hpp"

namespace cardioid::formats {

namespace {

using Reader = void (*)(const MeshText&, MeshBuilder&);

Reader by_extension(const std::string& path) {
    std::string extension = std::filesystem::path(path).extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    static constexpr std::pair<std::string_view, Reader> readers[] = {
        {".stl", read_stl}, {".obj", read_obj},   {".ply", read_ply},  {".off", read_off},  {".amf", read_amf},
        {".3mf", read_3mf}, {".gltf", read_gltf}, {".glb", read_gltf}, {".nef3", read_nef3}};
    for (const auto& [name, reader] : readers)
        if (extension == name) return reader;
    return nullptr;
}

Reader by_content(std::string_view bytes) {
    if (bytes.starts_with("ply\n") || bytes.starts_with("ply\r")) return read_ply;
    if (bytes.starts_with("solid") || is_binary_stl(bytes)) return read_stl;
    if (bytes.starts_with("OFF") || bytes.starts_with("COFF")) return read_off;
    if (bytes.starts_with("Selective Nef Complex")) return read_nef3;
    if (bytes.starts_with("PK\x03\x04")) return read_3mf;
    if (bytes.starts_with("glTF")) return read_gltf;
    if (bytes.starts_with("v ") || bytes.find("\nv ") != std::string_view::npos) return read_obj;
    return nullptr;
}

}  // namespace

std::string read_bytes(const std::string& path) {
    std::error_code ignored;  // a pipe or device has no size, so it is read piece by piece
    if (std::filesystem::is_directory(path, ignored))
        throw Error(ErrorCode::io, path + ": found a directory, wanted a mesh file");
    errno = 0;
    std::ifstream in(path, std::ios::binary);
    if (!in) throw Error(ErrorCode::io, path + ": cannot read it: " + std::strerror(errno));
    constexpr std::size_t piece = 1U << 20;
    std::string out;
    const auto size = std::filesystem::file_size(path, ignored);
    if (!ignored) out.reserve(size + 1);
    for (std::size_t got = piece; got > 0;) {
        const std::size_t before = out.size();
        out.resize(before + piece);
        in.read(out.data() + before, static_cast<std::streamsize>(piece));
        got = static_cast<std::size_t>(in.gcount());
        out.resize(before + got);
    }
    if (in.bad()) throw Error(ErrorCode::io, path + ": cannot read it: " + std::strerror(errno));
    return out;
}

TriangleMesh read_mesh(const std::string& path) {
    const std::string bytes = read_bytes(path);
    if (bytes.empty()) throw Error(ErrorCode::bad_input, path + ":1: found an empty file, wanted a mesh");
    const Reader named = by_extension(path);
    const Reader read = named ? named : by_content(bytes);
    if (!read)
        throw Error(ErrorCode::bad_input,
                    path + ":1: found no known mesh format, wanted STL, OBJ, PLY, OFF, AMF, 3MF, NEF3 or glTF");
    MeshBuilder mesh;
    read({bytes, path}, mesh);
    if (!mesh.has_faces()) throw Error(ErrorCode::bad_input, path + ":1: found no faces, wanted at least one");
    return mesh.finish();
}

}  // namespace cardioid::formats
