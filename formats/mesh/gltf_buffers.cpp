#include "formats/mesh/gltf_buffers.hpp"

#include <bit>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "formats/mesh/byte_cursor.hpp"
#include "formats/mesh/mesh_file.hpp"
#include "rt_core/api/error.hpp"

namespace cardioid::formats {

namespace {

using Json = nlohmann::json;

std::string decode_base64(std::string_view text) {
    std::string out;
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
        const int value = c >= 'A' && c <= 'Z'   ? c - 'A'
                          : c >= 'a' && c <= 'z' ? c - 'a' + 26
                          : c >= '0' && c <= '9' ? c - '0' + 52
                          : c == '+'             ? 62
                          : c == '/'             ? 63
                                                 : -1;
        if (value < 0) continue;  // padding
        bits = bits << 6 | static_cast<std::uint32_t>(value);
        if ((count += 6) < 8) continue;
        count -= 8;
        out += static_cast<char>(bits >> count & 0xFF);
    }
    return out;
}

std::string content(const std::string& uri, const std::string& file) {
    if (uri.starts_with("data:")) return decode_base64(std::string_view(uri).substr(uri.find(',') + 1));
    return read_bytes((std::filesystem::path(file).parent_path() / uri).string());
}

}  // namespace

GltfParts split_gltf(std::string_view bytes, const std::string& file) {
    if (!bytes.starts_with("glTF")) return {bytes, {}};
    ByteCursor in(bytes, file, 0, std::endian::little);
    in.skip(12);  // magic, version, length
    GltfParts out;
    constexpr std::uint32_t json = 0x4E4F534A, binary = 0x004E4942;
    while (in.left() >= 8) {
        const auto size = in.take<std::uint32_t>();
        const auto kind = in.take<std::uint32_t>();
        if (size > in.left()) in.fail("a chunk longer than the file", "a GLB");
        const std::string_view chunk = bytes.substr(in.position(), size);
        if (kind == json) out.json = chunk;
        if (kind == binary) out.binary = chunk;
        in.skip(size);
    }
    return out;
}

GltfBuffers::GltfBuffers(const Json& root, std::string_view binary, const std::string& file)
    : root_(root), file_(file) {
    for (const Json& buffer : root.value("buffers", Json::array()))
        buffers_.push_back(buffer.contains("uri") ? content(buffer["uri"].get<std::string>(), file)
                                                  : std::string(binary));
}

std::string GltfBuffers::elements(const Json& accessor, std::size_t width) const {
    const Json& view = root_.at("bufferViews").at(accessor.at("bufferView").get<std::size_t>());
    const std::string& buffer = buffers_.at(view.at("buffer").get<std::size_t>());
    const std::size_t count = accessor.at("count").get<std::size_t>();
    const std::size_t stride = view.value("byteStride", width);
    const std::size_t begin = view.value("byteOffset", std::size_t{0}) + accessor.value("byteOffset", std::size_t{0});
    if (count > 0 && (stride < width || (count > 1 && stride > buffer.size()) || begin > buffer.size() ||
                      count > buffer.size() / width || begin + (count - 1) * stride + width > buffer.size()))
        throw Error(ErrorCode::bad_input, file_ + ": found an accessor past the end of its buffer");
    std::string out;
    out.reserve(count * width);
    for (std::size_t i = 0; i < count; ++i) out.append(buffer, begin + i * stride, width);
    return out;
}

std::vector<Vec3d> GltfBuffers::vectors(std::size_t accessor) const {
    const Json& given = root_.at("accessors").at(accessor);
    constexpr int float_type = 5126;
    if (given.at("componentType") != float_type || given.at("type") != "VEC3")
        throw Error(ErrorCode::bad_input, file_ + ": found positions that are not three floats");
    const std::string bytes = elements(given, 12);
    std::vector<Vec3d> out(bytes.size() / 12);
    ByteCursor in(bytes, file_, 0, std::endian::little);
    for (Vec3d& v : out) {
        const float x = in.take<float>(), y = in.take<float>(), z = in.take<float>();
        v = {double(x), double(y), double(z)};
        if (!is_finite(v)) throw Error(ErrorCode::bad_input, file_ + ": found a position that is not finite");
    }
    return out;
}

std::vector<std::uint32_t> GltfBuffers::indices(std::size_t accessor) const {
    const Json& given = root_.at("accessors").at(accessor);
    const int type = given.at("componentType");
    const std::size_t width = type == 5121 ? 1 : type == 5123 ? 2 : 4;
    const std::string bytes = elements(given, width);
    ByteCursor in(bytes, file_, 0, std::endian::little);
    std::vector<std::uint32_t> out(bytes.size() / width);
    for (std::uint32_t& i : out)
        i = width == 1 ? in.take<std::uint8_t>() : width == 2 ? in.take<std::uint16_t>() : in.take<std::uint32_t>();
    return out;
}

}  // namespace cardioid::formats
