#include "formats/mesh/ply_header.hpp"

#include <array>
#include <utility>

#include "formats/mesh/text_cursor.hpp"

namespace cardioid::formats {

namespace {

constexpr std::array<std::pair<std::string_view, PlyType>, 16> type_names{{{"char", PlyType::i8},
                                                                           {"int8", PlyType::i8},
                                                                           {"uchar", PlyType::u8},
                                                                           {"uint8", PlyType::u8},
                                                                           {"short", PlyType::i16},
                                                                           {"int16", PlyType::i16},
                                                                           {"ushort", PlyType::u16},
                                                                           {"uint16", PlyType::u16},
                                                                           {"int", PlyType::i32},
                                                                           {"int32", PlyType::i32},
                                                                           {"uint", PlyType::u32},
                                                                           {"uint32", PlyType::u32},
                                                                           {"float", PlyType::f32},
                                                                           {"float32", PlyType::f32},
                                                                           {"double", PlyType::f64},
                                                                           {"float64", PlyType::f64}}};

PlyType read_type(TextCursor& in) {
    const std::string_view word = in.word_in_line();
    for (const auto& [name, type] : type_names)
        if (word == name) return type;
    in.fail(word, "a type as \"float\" or \"int\"");
}

PlyProperty read_property(TextCursor& in) {
    PlyProperty out;
    TextCursor ahead = in;
    if (ahead.word_in_line() == "list") {
        in = ahead;
        out.is_list = true;
        out.count_type = read_type(in);
        if (out.count_type >= PlyType::f32)
            in.fail("a list counted by fractions", "a whole type before the list's type");
    }
    out.type = read_type(in);
    out.name = in.word_in_line();
    if (out.name.empty()) in.fail({}, "the property's name");
    return out;
}

PlyEncoding read_encoding(TextCursor& in) {
    const std::string_view word = in.word_in_line();
    if (word == "ascii") return PlyEncoding::ascii;
    if (word == "binary_little_endian") return PlyEncoding::little_endian;
    if (word == "binary_big_endian") return PlyEncoding::big_endian;
    in.fail(word, "\"ascii\", \"binary_little_endian\" or \"binary_big_endian\"");
}

PlyElement read_element(TextCursor& in) {
    PlyElement out;
    out.name = in.word_in_line();
    const std::string_view word = in.word_in_line();
    const std::int64_t count = in.integer(word, "the number of elements");
    if (count < 0) in.fail(word, "the number of elements");
    out.count = static_cast<std::size_t>(count);
    out.line = in.line();
    return out;
}

}  // namespace

std::size_t size_of(PlyType type) {
    constexpr std::array<std::size_t, 8> sizes{1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[static_cast<std::size_t>(type)];
}

std::size_t PlyElement::least_size() const {
    std::size_t out = 0;
    for (const PlyProperty& p : properties) out += size_of(p.is_list ? p.count_type : p.type);
    return out;
}

PlyHeader read_ply_header(const MeshText& text) {
    TextCursor in(text.bytes, text.file);
    PlyHeader out;
    if (const std::string_view magic = in.word_in_line(); magic != "ply") in.fail(magic, "\"ply\"");
    bool has_format = false;
    for (in.skip_line(); !in.at_end(); in.skip_line()) {
        const std::string_view word = in.word_in_line();
        if (word == "format") {
            out.encoding = read_encoding(in);
            has_format = true;
        } else if (word == "element") {
            out.elements.push_back(read_element(in));
        } else if (word == "property") {
            if (out.elements.empty()) in.fail(word, "\"element\" before it");
            out.elements.back().properties.push_back(read_property(in));
        } else if (word == "end_header") {
            if (!has_format) in.fail(word, "a line \"format\" before it");
            in.skip_line();
            out.size = text.bytes.size() - in.rest().size();
            out.lines = in.line() - 1;
            return out;
        } else if (!word.empty() && word != "comment" && word != "obj_info") {
            in.fail(word, "\"format\", \"element\", \"property\", \"comment\" or \"end_header\"");
        }
    }
    in.fail({}, "\"end_header\"");
}

}  // namespace cardioid::formats
