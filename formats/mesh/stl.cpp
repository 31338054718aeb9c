#include <algorithm>
#include <cmath>

#include "formats/mesh/byte_cursor.hpp"
#include "formats/mesh/readers.hpp"
#include "formats/mesh/text_cursor.hpp"

namespace cardioid::formats {

namespace {

constexpr std::size_t header_size = 80, start = header_size + 4, record_size = 50;

std::uint32_t written_count(std::string_view bytes) {
    return ByteCursor(bytes.substr(header_size), {}, header_size, std::endian::little).take<std::uint32_t>();
}

/// Keywords in any case, as many programs write them.
bool is(std::string_view word, std::string_view keyword) {
    return std::ranges::equal(word, keyword,
                              [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b; });
}

/// "solid" at the beginning is not enough: binary headers hold it, too.
bool looks_like_text(std::string_view bytes) {
    constexpr std::size_t looked_at = 1024;
    const std::string_view head = bytes.substr(0, looked_at);
    const bool printable = std::ranges::all_of(
        head, [](char c) { return static_cast<unsigned char>(c) >= ' ' || (c >= '\t' && c <= '\r'); });
    const std::size_t first = head.find_first_not_of(" \t\r\n");
    return printable && first != std::string_view::npos && is(head.substr(first, 5), "solid");
}

void expect(TextCursor& in, std::string_view keyword) {
    const std::string_view word = in.word();
    if (!is(word, keyword)) in.fail(word, quoted(keyword));
}

/// The corners of a facet after the word "facet". The normal is not read: programs write all sorts of things there.
void read_facet(TextCursor& in, MeshBuilder& mesh, std::vector<std::uint32_t>& corners) {
    expect(in, "normal");
    for (int i = 0; i < 3; ++i)
        if (const std::string_view word = in.word(); word.empty()) in.fail(word, "a normal of three numbers");
    expect(in, "outer");
    expect(in, "loop");
    corners.clear();
    for (std::string_view word = in.word(); !is(word, "endloop"); word = in.word()) {
        if (!is(word, "vertex")) in.fail(word, "\"vertex\" or \"endloop\"");
        const double x = in.number(), y = in.number(), z = in.number();
        corners.push_back(static_cast<std::uint32_t>(mesh.vertex_count()));
        mesh.add_vertex({x, y, z});
    }
    if (corners.size() < 3) in.fail("endloop", "at least three corners");
    expect(in, "endfacet");
    mesh.add_face(corners);
}

void read_text(const MeshText& text, MeshBuilder& mesh) {
    TextCursor in(text.bytes, text.file);
    std::vector<std::uint32_t> corners;
    bool open = false;
    for (std::string_view word = in.word(); !word.empty(); word = in.word()) {
        if (!open && is(word, "solid")) {
            open = true;
            in.skip_line();
        } else if (open && is(word, "facet")) {
            read_facet(in, mesh, corners);
        } else if (open && is(word, "endsolid")) {
            open = false;
            in.skip_line();
        } else {
            in.fail(word, open ? "\"facet\" or \"endsolid\"" : "\"solid\"");
        }
    }
    if (open) in.fail({}, "\"endsolid\"");
}

void read_binary(const MeshText& text, MeshBuilder& mesh) {
    ByteCursor in(text.bytes, text.file, 0, std::endian::little);
    if (text.bytes.size() < start)
        in.fail(std::to_string(text.bytes.size()) + " bytes", "\"solid\" or at least 84 bytes of binary STL");
    in.skip(header_size);
    const std::size_t count = written_count(text.bytes), room = (text.bytes.size() - start) / record_size;
    if (count > room)
        in.fail("a count of " + std::to_string(count) + " triangles",
                "at most " + std::to_string(room) + ", for which the file has room");
    in.skip(4);
    mesh.reserve(3 * count, count);
    for (std::size_t t = 0; t < count; ++t) {
        in.skip(12);  // the normal
        const auto first = static_cast<std::uint32_t>(mesh.vertex_count());
        for (int i = 0; i < 3; ++i) {
            const float x = in.take<float>(), y = in.take<float>(), z = in.take<float>();
            if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z))
                in.fail("a corner that is not finite", "a finite one");
            mesh.add_vertex({x, y, z});
        }
        in.skip(2);
        mesh.add_face(std::array{first, first + 1, first + 2});
    }
}

}  // namespace

bool is_binary_stl(std::string_view bytes) {
    return bytes.size() >= start && bytes.size() == start + record_size * written_count(bytes);
}

void read_stl(const MeshText& text, MeshBuilder& mesh) {
    if (!is_binary_stl(text.bytes) && looks_like_text(text.bytes))
        read_text(text, mesh);
    else
        read_binary(text, mesh);
}

}  // namespace cardioid::formats
