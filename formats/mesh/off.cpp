#include "formats/mesh/readers.hpp"
#include "formats/mesh/text_cursor.hpp"

namespace cardioid::formats {

namespace {

/// The next word, comments left out.
std::string_view next(TextCursor& in) {
    for (;;) {
        const std::string_view word = in.word();
        if (!word.starts_with('#')) return word;
        in.skip_line();
    }
}

std::size_t count(TextCursor& in, const char* wanted) {
    const std::int64_t n = in.integer(next(in), wanted);
    if (n < 0) in.fail(std::to_string(n), wanted);
    return static_cast<std::size_t>(n);
}

}  // namespace

void read_off(const MeshText& text, MeshBuilder& mesh) {
    TextCursor in(text.bytes, text.file);
    std::string_view word = next(in);
    const bool more_per_vertex = word == "COFF" || word == "NOFF";  // colours or normals
    if (word == "OFF" || more_per_vertex) word = next(in);
    const std::int64_t vertices = in.integer(word, "the number of vertices");
    const std::size_t faces = count(in, "the number of faces");
    count(in, "the number of edges");
    for (std::int64_t i = 0; i < vertices; ++i) {
        const auto coordinate = [&] { return in.number(next(in), "a coordinate"); };
        const double x = coordinate(), y = coordinate(), z = coordinate();
        mesh.add_vertex({x, y, z});
        if (more_per_vertex) in.skip_line();
    }
    std::vector<std::uint32_t> corners;
    for (std::size_t i = 0; i < faces; ++i) {
        const std::size_t n = count(in, "the number of a face's corners");
        corners.clear();
        for (std::size_t k = 0; k < n; ++k) {
            const std::int64_t v = in.integer(next(in), "a vertex number");
            if (v < 0 || v >= vertices) in.fail(std::to_string(v), "a vertex number below " + std::to_string(vertices));
            corners.push_back(static_cast<std::uint32_t>(v));
        }
        mesh.add_face(corners);
        in.skip_line();  // a colour
    }
}

}  // namespace cardioid::formats
