#include <algorithm>
#include <optional>
#include <utility>

#include "formats/brlcad/read/byte_reader.hpp"
#include "formats/brlcad/read/readers.hpp"
#include "formats/brlcad/solid_kinds.hpp"

namespace cardioid::formats::brlcad {

namespace {

constexpr int arbn_minor = 14, pipe_minor = 15, sphere_minor = 10, bot_minor = 30;
constexpr int sketch_minor = 26, extrude_minor = 27, revolve_minor = 40;
constexpr int ars_minor = 5, conic_minor = 7, poly_minor = 8, dsp_minor = 25, metaball_minor = 36;
/// What a curve of a sketch begins with: its kind in four letters.
constexpr std::uint64_t line_magic = 0x6C736567, arc_magic = 0x63617263, bezier_magic = 0x62657A69,
                        nurb_magic = 0x6E757262;

void reals(ByteReader& in, std::uint64_t n, const char* what, std::vector<double>& out) {
    if (n > in.left() / 8) in.fail(fmt::format("found {} bytes, wanted {} numbers of {}", in.left(), n, what));
    out.reserve(out.size() + static_cast<std::size_t>(n));
    for (std::uint64_t i = 0; i < n; ++i) out.push_back(in.real(what));
}

Solid pipe(ByteReader in) {
    Solid out{.kind = SolidKind::pipe, .type = "pipe"};
    const std::uint64_t points = in.whole(2, "a pipe's points");
    if (points > in.left() / 48) in.fail(fmt::format("found {} bytes, wanted {} points of a pipe", in.left(), points));
    reals(in, points * 6, "a pipe", out.numbers);
    return out;
}

Solid arbn(ByteReader in) {
    Solid out{.kind = SolidKind::arbn, .type = "arbn"};
    const std::uint64_t planes = in.whole(2, "an arbn's planes");
    if (planes > in.left() / 32) in.fail(fmt::format("found {} bytes, wanted {} planes", in.left(), planes));
    reals(in, planes * 4, "an arbn", out.numbers);
    return out;
}

Solid bot(ByteReader in) {
    Solid out{.kind = SolidKind::bot, .type = "bot"};
    const std::uint64_t vertices = in.whole(2, "a bot's corners"), faces = in.whole(2, "a bot's triangles");
    out.orientation = static_cast<int>(in.whole(0, "a bot's orientation"));
    out.mode = static_cast<int>(in.whole(0, "a bot's mode"));
    static_cast<void>(in.whole(0, "a bot's flags"));
    if (vertices > in.left() / 24) in.fail(fmt::format("found {} bytes, wanted {} corners", in.left(), vertices));
    reals(in, vertices * 3, "a bot", out.numbers);
    if (faces > in.left() / 12) in.fail(fmt::format("found {} bytes, wanted {} triangles", in.left(), faces));
    for (std::uint64_t i = 0; i < faces * 3; ++i) {
        const std::uint64_t corner = in.whole(2, "a bot's triangle");
        if (corner >= vertices) in.fail(fmt::format("found corner {}, wanted one below {}", corner, vertices));
        out.corners.push_back(static_cast<std::uint32_t>(corner));
    }
    if (out.mode == 3 || out.mode == 4) {
        reals(in, faces, "a bot's thickness", out.thickness);
        out.appended = appended_plates(in.text("a bot's plates"), static_cast<std::size_t>(faces));
    }
    return out;
}

Solid ars(ByteReader in) {
    Solid out{.kind = SolidKind::ars, .type = "ars"};
    const std::uint64_t curves = in.whole(2, "an ars' curves"), points = in.whole(2, "an ars' points");
    if (points && curves > in.left() / 24 / points)
        in.fail(fmt::format("found {} bytes, wanted {} curves of {} points", in.left(), curves, points));
    out.points_a_curve = static_cast<std::size_t>(points);
    reals(in, curves * points * 3, "an ars", out.numbers);
    return out;
}

/// Polygons become the fans of a bot; their normals are of no use.
Solid poly(ByteReader in) {
    Solid out{.kind = SolidKind::bot, .orientation = 1, .type = "poly"};
    const std::uint64_t polygons = in.whole(2, "a poly's polygons");
    for (std::uint64_t i = 0; i < polygons; ++i) {
        const std::uint64_t points = in.whole(2, "a polygon's corners");
        if (points > in.left() / 48) in.fail(fmt::format("found {} bytes, wanted {} corners", in.left(), points));
        const auto first = static_cast<std::uint32_t>(out.numbers.size() / 3);
        reals(in, points * 3, "a polygon", out.numbers);
        static_cast<void>(in.take(points * 24, "normals"));
        for (std::uint32_t k = 2; k < points; ++k)
            out.corners.insert(out.corners.end(), {first, first + k - 1, first + k});
    }
    return out;
}

Solid dsp(ByteReader in) {
    Solid out{.kind = SolidKind::dsp, .type = "dsp"};
    for (const char* key : {"w", "n"}) out.fields[key] = fmt::format("{}", in.whole(2, "a dsp's size"));
    std::vector<double> matrix;
    reals(in, 16, "a dsp", matrix);
    out.fields["stom"] = fmt::format("{}", fmt::join(matrix, " "));
    out.fields["sm"] = fmt::format("{}", in.whole(1, "a dsp"));
    for (const char* key : {"src", "cut"}) out.fields[key] = std::string(in.take(1, "a dsp"));
    std::string_view name = in.take(in.left(), "a dsp's data");
    out.fields["name"] = std::string(name.substr(0, name.find('\0')));
    return out;
}

Solid metaball(ByteReader in) {
    Solid out{.kind = SolidKind::metaball, .type = "metaball"};
    const std::uint64_t points = in.whole(2, "a metaball's points");
    out.method = static_cast<int>(in.whole(2, "a metaball's method") & 0xFF);
    if (points > in.left() / 40) in.fail(fmt::format("found {} bytes, wanted {} points", in.left(), points));
    reals(in, 1 + points * 5, "a metaball", out.numbers);
    return out;
}

std::uint32_t corner_of(ByteReader& in, std::uint64_t corners) {
    const std::uint64_t corner = in.whole(2, "a sketch's curve");
    if (corner >= corners) in.fail(fmt::format("found corner {}, wanted one below {}", corner, corners));
    return static_cast<std::uint32_t>(corner);
}

/// Nothing where the curve is of a kind that is not read, as its length is not known.
std::optional<SketchCurve> curve(ByteReader& in, std::uint64_t corners) {
    const std::uint64_t magic = in.whole(2, "a sketch's curve");
    SketchCurve out;
    if (magic == line_magic || magic == arc_magic) {
        for (int i = 0; i < 2; ++i) out.corners.push_back(corner_of(in, corners));
        if (magic == line_magic) return out;
        out.kind = SketchCurve::Kind::arc;
        out.clockwise = in.whole(2, "an arc") != 0;
        out.centre_left = in.whole(2, "an arc") != 0;
        out.radius = in.real("an arc");
        return out;
    }
    if (magic == nurb_magic) {
        out.kind = SketchCurve::Kind::nurb;
        static_cast<void>(in.whole(2, "a NURB's order"));
        const bool rational = (in.whole(2, "a NURB's points") & 1) != 0;
        reals(in, in.whole(2, "a NURB's knots"), "a NURB's knots", out.knots);
        const std::uint64_t points = in.whole(2, "a NURB's points");
        if (points > in.left() / 4) in.fail(fmt::format("found a NURB of {} points in {} bytes", points, in.left()));
        for (std::uint64_t i = 0; i < points; ++i) out.corners.push_back(corner_of(in, corners));
        if (rational) reals(in, points, "a NURB's weights", out.weights);
        return out;
    }
    if (magic != bezier_magic) return std::nullopt;
    out.kind = SketchCurve::Kind::bezier;
    const std::uint64_t degree = in.whole(2, "a curve's degree");
    if (degree >= in.left() / 4) in.fail(fmt::format("found a curve of degree {} in {} bytes", degree, in.left()));
    for (std::uint64_t i = 0; i <= degree; ++i) out.corners.push_back(corner_of(in, corners));
    return out;
}

Solid sketch(ByteReader in) {
    Solid out{.kind = SolidKind::sketch, .type = "sketch"};
    reals(in, 9, "a sketch", out.numbers);
    const std::uint64_t corners = in.whole(2, "a sketch's corners"), curves = in.whole(2, "a sketch's curves");
    if (corners > in.left() / 16) in.fail(fmt::format("found {} bytes, wanted {} corners", in.left(), corners));
    reals(in, corners * 2, "a sketch", out.numbers);
    for (std::uint64_t i = 0; i < curves; ++i) {
        std::optional<SketchCurve> next = curve(in, corners);
        if (!next) return {.type = "sketch with a curve other than line, arc, bezier and nurb"};
        out.curves.push_back(std::move(*next));
    }
    return out;
}

Solid extrude(ByteReader in) {
    Solid out{.kind = SolidKind::extrude, .type = "extrude"};
    reals(in, 12, "an extrude", out.numbers);
    static_cast<void>(in.whole(2, "an extrude's key point"));
    out.sketch = in.text("a sketch's name");
    return out;
}

Solid revolve(ByteReader in) {
    Solid out{.kind = SolidKind::revolve, .type = "revolve"};
    reals(in, 10, "a revolve", out.numbers);
    out.sketch = in.text("a sketch's name");
    return out;
}

}  // namespace

std::vector<bool> appended_plates(std::string_view digits, std::size_t plates) {
    std::vector<bool> out(plates);
    for (std::size_t i = 0; i < plates && i / 4 < digits.size(); ++i) {
        const char c = digits[digits.size() - 1 - i / 4];
        const int value = c >= '0' && c <= '9' ? c - '0' : c >= 'a' && c <= 'f' ? c - 'a' + 10 : 0;
        out[i] = (value >> (i % 4) & 1) != 0;
    }
    return out;
}

Solid read_body(int minor, std::string_view body, const std::string& file, std::size_t offset) {
    ByteReader in(body, file, offset);
    if (minor == pipe_minor) return pipe(in);
    if (minor == arbn_minor) return arbn(in);
    if (minor == bot_minor) return bot(in);
    if (minor == sketch_minor) return sketch(in);
    if (minor == extrude_minor) return extrude(in);
    if (minor == revolve_minor) return revolve(in);
    if (minor == ars_minor) return ars(in);
    if (minor == poly_minor) return poly(in);
    if (minor == dsp_minor) return dsp(in);
    if (minor == metaball_minor) return metaball(in);
    for (const auto& [number, kind] : {std::pair{12, SolidKind::ebm}, {13, SolidKind::vol}, {24, SolidKind::hf}})
        if (minor == number) return {.kind = kind, .type = minor_name(minor), .fields = fields_of(body)};
    const SolidRow* row = find_row_by_minor(minor == sphere_minor ? 3 : minor == conic_minor ? 2 : minor);
    if (!row) return {.kind = kind_without_body(minor_name(minor)), .type = minor_name(minor)};
    Solid out{.kind = row->kind, .type = row->name};
    reals(in, row->count(), row->name, out.numbers);
    return out;
}

Combination read_combination(std::string_view body, const std::string& file, std::size_t offset) {
    ByteReader in(body, file, offset);
    const auto width = static_cast<unsigned>(in.whole(0, "a width"));
    if (width > 3) in.fail(fmt::format("found width {}, wanted 0 to 3", width));
    const std::uint64_t matrices = in.whole(width, "a tree"), leaves = in.whole(width, "a tree");
    const std::uint64_t leaf_bytes = in.whole(width, "a tree"), steps = in.whole(width, "a tree");
    static_cast<void>(in.whole(width, "a tree"));  // the depth of its stack
    if (matrices > in.left() / 128) in.fail(fmt::format("found {} bytes, wanted {} matrices", in.left(), matrices));
    std::vector<double> numbers;
    reals(in, matrices * 16, "matrices", numbers);
    ByteReader names(in.take(leaf_bytes, "members"), file, offset);
    std::vector<Step> members;
    for (std::uint64_t i = 0; i < leaves; ++i) {
        Step step{.name = names.text("a member's name")};
        const std::uint64_t index = names.whole(width, "a matrix's number");
        const unsigned bits = 8U << width;
        const bool none = (index >> (bits - 1) & 1) != 0;
        if (!none && index >= matrices)
            names.fail(fmt::format("found matrix {}, wanted one below {}", index, matrices));
        if (!none) {
            step.matrix.emplace();
            for (std::size_t k = 0; k < 16; ++k) (*step.matrix)[k] = numbers[static_cast<std::size_t>(index) * 16 + k];
        }
        members.push_back(std::move(step));
    }
    Combination out;
    if (steps == 0) {
        for (Step& member : members) {
            out.steps.push_back(std::move(member));
            if (out.steps.size() > 1) out.steps.push_back({Step::Op::unite});
        }
        return out;
    }
    std::size_t next = 0;
    for (const char c : in.take(steps, "a tree")) {
        if (c < 1 || c > 6) in.fail(fmt::format("found step {}, wanted 1 to 6", static_cast<int>(c)));
        if (c == 1 && next == members.size()) in.fail("found more members in the tree than names");
        if (c == 1)
            out.steps.push_back(std::move(members[next++]));
        else
            out.steps.push_back({static_cast<Step::Op>(c - 1)});
    }
    if (!well_formed(out.steps)) in.fail("found a tree that does not end in one value");
    return out;
}

}  // namespace cardioid::formats::brlcad
