#include "formats/mesh/readers.hpp"
#include "formats/mesh/text_cursor.hpp"

namespace cardioid::formats {

namespace {

/// The greatest vertex number so far and where it stands: faces may come before their vertices.
struct GreatestIndex {
    std::int64_t value = 0;
    std::size_t line = 0;
    std::string word;
};

/// "7", "7/1", "7//3", "7/1/3", "-1": the vertex as an index from 0; negative ones count back from the last vertex.
std::uint32_t corner(const TextCursor& in, std::string_view word, std::size_t vertices, GreatestIndex& greatest) {
    constexpr std::int64_t most = 0xFFFFFFFF;
    constexpr auto wanted = "a vertex number, as 7 or 7/1/3";
    const std::int64_t number = in.integer(word.substr(0, word.find('/')), wanted);
    const std::int64_t index = number < 0 ? static_cast<std::int64_t>(vertices) + number : number - 1;
    if (number == 0 || index < 0 || index >= most)
        in.fail(word, "a vertex number from 1, or down from -1 to -" + std::to_string(vertices));
    if (index + 1 > greatest.value) greatest = {index + 1, in.line(), std::string(word)};
    return static_cast<std::uint32_t>(index);
}

}  // namespace

void read_obj(const MeshText& text, MeshBuilder& mesh) {
    TextCursor in(text.bytes, text.file);
    std::vector<std::uint32_t> corners;
    GreatestIndex greatest;
    for (; !in.at_end(); in.skip_line()) {
        const std::string_view keyword = in.word_in_line();
        if (keyword == "v") {
            const auto coordinate = [&] { return in.number(in.word_in_line(), "a coordinate"); };
            const double x = coordinate(), y = coordinate(), z = coordinate();
            mesh.add_vertex({x, y, z});
        } else if (keyword == "f" || keyword == "fo") {
            corners.clear();
            for (std::string_view word = in.word_in_line(); !word.empty() && word[0] != '#'; word = in.word_in_line())
                corners.push_back(corner(in, word, mesh.vertex_count(), greatest));
            if (corners.size() < 3) in.fail({}, "at least three corners of a face");
            mesh.add_face(corners);
        }
    }
    if (greatest.value > static_cast<std::int64_t>(mesh.vertex_count()))
        in.fail_at(greatest.line, greatest.word,
                   "one of the file's " + std::to_string(mesh.vertex_count()) + " vertices");
}

}  // namespace cardioid::formats
