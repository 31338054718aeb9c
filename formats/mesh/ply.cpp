#include <algorithm>
#include <cmath>

#include "formats/mesh/byte_cursor.hpp"
#include "formats/mesh/ply_header.hpp"
#include "formats/mesh/readers.hpp"
#include "formats/mesh/text_cursor.hpp"

namespace cardioid::formats {

namespace {

/// Values of an ASCII body; types do not matter there.
class TextValues {
public:
    TextValues(const MeshText& text, const PlyHeader& header)
        : in_(text.bytes.substr(header.size), text.file, header.lines + 1) {}
    double value(PlyType) { return in_.number(); }
    /// Nothing in it can be shorter than a digit and a space.
    [[nodiscard]] std::size_t room(const PlyElement&) const { return in_.rest().size() / 2 + 1; }
    [[nodiscard]] std::size_t room(PlyType) const { return in_.rest().size() / 2 + 1; }
    [[noreturn]] void fail(std::string_view found, std::string_view wanted) const { in_.fail(found, wanted); }

private:
    TextCursor in_;
};

/// Values of a binary body.
class BinaryValues {
public:
    BinaryValues(const MeshText& text, const PlyHeader& header)
        : in_(text.bytes.substr(header.size), text.file, header.size,
              header.encoding == PlyEncoding::little_endian ? std::endian::little : std::endian::big) {}
    double value(PlyType type) {
        switch (type) {
            case PlyType::i8:
                return in_.take<std::int8_t>();
            case PlyType::u8:
                return in_.take<std::uint8_t>();
            case PlyType::i16:
                return in_.take<std::int16_t>();
            case PlyType::u16:
                return in_.take<std::uint16_t>();
            case PlyType::i32:
                return in_.take<std::int32_t>();
            case PlyType::u32:
                return in_.take<std::uint32_t>();
            case PlyType::f32:
                return static_cast<double>(in_.take<float>());
            case PlyType::f64:
                return in_.take<double>();
        }
        return 0;
    }
    [[nodiscard]] std::size_t room(const PlyElement& element) const { return in_.left() / element.least_size(); }
    [[nodiscard]] std::size_t room(PlyType type) const { return in_.left() / size_of(type); }
    [[noreturn]] void fail(std::string_view found, std::string_view wanted) const { in_.fail(found, wanted); }

private:
    ByteCursor in_;
};

std::string plain(double x) {
    std::string out = std::to_string(x);
    out.erase(out.find_last_not_of('0') + 1);
    if (out.ends_with('.')) out.pop_back();
    return out;
}

template <class Values>
std::size_t list_size(Values& in, const PlyProperty& property) {
    const double count = in.value(property.count_type);
    if (!(count >= 0) || count != std::floor(count) || count > static_cast<double>(in.room(property.type)))
        in.fail("a list of " + plain(count) + " values", "as many as the file holds");
    return static_cast<std::size_t>(count);
}

/// Passes over a property that is not needed.
template <class Values>
void skip(Values& in, const PlyProperty& property) {
    const std::size_t count = property.is_list ? list_size(in, property) : 1;
    for (std::size_t i = 0; i < count; ++i) static_cast<void>(in.value(property.type));
}

template <class Values>
void read_vertex(Values& in, const PlyElement& element, MeshBuilder& mesh) {
    Vec3d p;
    for (const PlyProperty& property : element.properties) {
        const int axis = property.is_list || property.name.size() != 1 ? -1 : property.name[0] - 'x';
        if (axis < 0 || axis > 2)
            skip(in, property);
        else
            p[axis] = in.value(property.type);
    }
    if (!is_finite(p)) in.fail("a vertex that is not finite", "a finite one");
    mesh.add_vertex(p);
}

bool is_corner_list(const PlyProperty& p) {
    return p.is_list && (p.name == "vertex_indices" || p.name == "vertex_index");
}

template <class Values>
void read_face(Values& in, const PlyElement& element, std::size_t vertices, std::vector<std::uint32_t>& corners) {
    for (const PlyProperty& property : element.properties) {
        if (!is_corner_list(property)) {
            skip(in, property);
            continue;
        }
        corners.resize(list_size(in, property));
        for (std::uint32_t& c : corners) {
            const double index = in.value(property.type);
            if (!(index >= 0 && index < static_cast<double>(vertices)) || index != std::floor(index))
                in.fail("vertex " + plain(index),
                        "one of the file's " + std::to_string(vertices) + " vertices, counted from 0");
            c = static_cast<std::uint32_t>(index);
        }
    }
}

std::size_t vertices_of(const PlyHeader& header) {
    for (const PlyElement& element : header.elements)
        if (element.name == "vertex") return element.count;
    return 0;
}

template <class Values>
void read_elements(Values in, const PlyHeader& header, MeshBuilder& mesh) {
    const std::size_t vertices = vertices_of(header);
    std::vector<std::uint32_t> corners;
    for (const PlyElement& element : header.elements) {
        if (element.properties.empty()) continue;
        if (element.count > in.room(element))
            in.fail("an element \"" + element.name + "\" of " + std::to_string(element.count) + " lines",
                    "as many as the file has room for");
        const bool is_vertex = element.name == "vertex", is_face = element.name == "face";
        if (is_vertex) mesh.reserve(element.count, 0);
        for (std::size_t i = 0; i < element.count; ++i) {
            if (is_vertex) {
                read_vertex(in, element, mesh);
            } else if (is_face) {
                read_face(in, element, vertices, corners);
                mesh.add_face(corners);
            } else {
                for (const PlyProperty& property : element.properties) skip(in, property);
            }
        }
    }
}

/// Throws unless there are vertices with x, y and z, and faces with corners.
void check_header(const MeshText& text, const PlyHeader& header) {
    const TextCursor where({}, text.file, header.lines);
    bool coordinates[3] = {}, faces = false;
    for (const PlyElement& element : header.elements)
        for (const PlyProperty& p : element.properties) {
            for (int axis = 0; axis < 3; ++axis)
                if (element.name == "vertex" && !p.is_list && p.name == std::string_view(&"xyz"[axis], 1))
                    coordinates[axis] = true;
            if (element.name == "face" && is_corner_list(p)) faces = true;
        }
    if (!coordinates[0] || !coordinates[1] || !coordinates[2])
        where.fail("end_header", "an element \"vertex\" with properties x, y and z");
    if (!faces) where.fail("end_header", "an element \"face\" with a list \"vertex_indices\"");
}

}  // namespace

void read_ply(const MeshText& text, MeshBuilder& mesh) {
    const PlyHeader header = read_ply_header(text);
    check_header(text, header);
    if (header.encoding == PlyEncoding::ascii)
        read_elements(TextValues(text, header), header, mesh);
    else
        read_elements(BinaryValues(text, header), header, mesh);
}

}  // namespace cardioid::formats
