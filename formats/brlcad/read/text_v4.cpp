#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "formats/brlcad/read/line_reader.hpp"
#include "formats/brlcad/read/readers.hpp"
#include "formats/brlcad/solid_kinds.hpp"

namespace cardioid::formats::brlcad {

namespace {

constexpr int numbers_of_a_solid = 24;

double norm(const double* v) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

/// The numbers of an S record in the order of version 5.
std::vector<double> converted(const SolidRow& row, std::vector<double> v) {
    if (row.kind == SolidKind::arb8)
        for (std::size_t i = 3; i < v.size(); ++i) v[i] += v[i % 3];  // corners are told from the first
    if (row.kind == SolidKind::tor) {
        const double tube = norm(&v[3]), ring = norm(&v[6]);
        for (std::size_t i = 3; i < 6; ++i) v[i] = tube > 0 ? v[i] / tube : 0;
        v[6] = ring, v[7] = tube;
    }
    v.resize(row.count());
    return v;
}

/// Members as they stand in the file, u - + before each.
struct Member {
    char op;
    Step step;
};

/// `-` and `+` bind to the union's part they follow: a u b - c + d is a u ((b - c) + d).
std::vector<Step> tree_of(std::vector<Member> members) {
    std::vector<Step> out;
    std::size_t parts = 0;
    const auto end_part = [&] {
        if (++parts > 1) out.push_back({Step::Op::unite});
    };
    for (std::size_t i = 0; i < members.size(); ++i) {
        const bool first = i == 0 || members[i].op == 'u';
        if (i > 0 && first) end_part();
        out.push_back(std::move(members[i].step));
        if (!first) out.push_back({members[i].op == '-' ? Step::Op::subtract : Step::Op::intersect});
    }
    if (!members.empty()) end_part();
    return out;
}

class TextReader {
public:
    TextReader(std::string_view text, const std::string& file) : in_(text, file) {}

    Database run() {
        more_ = in_.next_record();
        while (more_) record();
        return std::move(database_);
    }

private:
    void record() {
        const std::string_view letter = in_.wanted_word("a record's letter");
        if (letter == "I") return identity();
        if (letter == "S") return solid();
        if (letter == "C") return combination();
        if (letter == "m") return colour();
        if (letter == "p") return particle();
        if (letter == "w") return pipe();
        if (letter == "n") return arbn();
        if (letter == "s") return fields();
        if (letter == "A") return ars();
        if (letter == "P") return poly();
        if (letter == "t") return bot();
        if (letter == "d") return sketch();
        if (letter == "e") return extrude();
        if (letter == "b") return named("bspline");
        if (letter == "N") return named("nmg");
        if (letter == "c") return cline();
        // Rows of a record that is not read, or a letter of a newer program.
        static const std::string_view rows = "BDQM";
        if (rows.find(letter) == std::string_view::npos && !std::exchange(warned_, true))
            database_.warnings.push_back(
                fmt::format("{}: record \"{}\" is not known and left out, as are others like it", in_.place(),
                            letter.substr(0, 20)));
        more_ = in_.next_record();
    }

    void identity() {
        static constexpr const char* units[] = {"mm", "mm", "cm", "m", "in", "ft", "um", "km", "yd", "mi"};
        const long unit = in_.whole("a unit's number");
        if (unit >= 0 && unit < static_cast<long>(std::size(units))) database_.unit_mm = unit_mm(units[unit]);
        if (in_.next_line()) database_.title = std::string(in_.line());
        more_ = in_.next_record();
    }

    void solid() {
        const std::string place = in_.place();
        const long type = in_.whole("a solid's type");
        Object object{.name = std::string(in_.wanted_word("a solid's name")), .place = place};
        const SolidRow* row = find_row_by_v4(static_cast<int>(type));
        if (row) {
            static_cast<void>(in_.wanted_word("a solid's class"));
            std::vector<double> v;
            for (int i = 0; i < numbers_of_a_solid; ++i) v.push_back(in_.number("a solid's number"));
            object.solid = {.kind = row->kind, .numbers = converted(*row, std::move(v)), .type = row->name};
        } else {
            object.solid.type = type == 31 ? "grip" : fmt::format("type {}", type);
            object.solid.kind = kind_without_body(object.solid.type);
        }
        database_.add(std::move(object));
        more_ = in_.next_record();
    }

    void combination() {
        Object object{.place = in_.place()};
        Combination& out = object.combination.emplace();
        const std::string_view flag = in_.wanted_word("a combination's flag");
        out.region = flag != "N";
        object.name = std::string(in_.wanted_word("a combination's name"));
        out.region_id = static_cast<int>(in_.whole("a region's number"));
        out.air_code = static_cast<int>(in_.whole("an air code"));
        for (const char* what : {"a count of members", "a reference", "a material", "a line of sight"})
            static_cast<void>(in_.whole(what));
        const bool coloured = in_.whole("whether a colour follows") != 0;
        Colour8 colour{};
        for (std::uint8_t& c : colour) c = static_cast<std::uint8_t>(std::clamp(in_.whole("a colour"), 0L, 255L));
        if (coloured) out.colour = colour;
        const bool shader = in_.whole_or("whether a shader follows", 0) != 0;
        const bool parameters = in_.whole_or("whether parameters follow", 0) != 0;
        out.inherit = in_.whole_or("whether it inherits", 0) != 0;
        if (shader && in_.next_line()) out.shader = std::string(in_.line());
        if (parameters && in_.next_line()) out.shader += ' ' + std::string(in_.line());
        out.steps = tree_of(members());
        database_.add(std::move(object));
    }

    std::vector<Member> members() {
        std::vector<Member> out;
        while ((more_ = in_.next_record()) && in_.line().starts_with("M ")) {
            static_cast<void>(in_.word());
            const std::string_view op = in_.wanted_word("an operation");
            if (op != "u" && op != "-" && op != "+")
                in_.fail(fmt::format("found operation \"{}\", wanted u, - or +", op.substr(0, 20)));
            Member member{op[0], {.name = std::string(in_.wanted_word("a member's name"))}};
            Matrix matrix;
            for (double& x : matrix) x = in_.number("a matrix");
            static constexpr Matrix identity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
            if (matrix != identity) member.step.matrix = matrix;
            out.push_back(std::move(member));
        }
        return out;
    }

    void colour() {
        static_cast<void>(in_.wanted_word("flags"));
        ColourRange range;
        range.low = in_.whole("a region's number"), range.high = in_.whole("a region's number");
        for (std::uint8_t& c : range.colour) c = static_cast<std::uint8_t>(std::clamp(in_.whole("a colour"), 0L, 255L));
        database_.colours.push_back(range);
        more_ = in_.next_record();
    }

    void particle() {
        Object object{.place = in_.place()};
        object.name = std::string(in_.wanted_word("a particle's name"));
        object.solid = {.kind = SolidKind::part, .type = "part"};
        for (int i = 0; i < 8; ++i) object.solid.numbers.push_back(in_.number("a particle's number"));
        database_.add(std::move(object));
        more_ = in_.next_record();
    }

    void pipe() {
        Object object{.place = in_.place()};
        object.name = std::string(in_.wanted_word("a pipe's name"));
        object.solid = {.kind = SolidKind::pipe, .type = "pipe"};
        while ((more_ = in_.next_record()) && !in_.line().starts_with("END_PIPE")) {
            double v[6];
            for (double& x : v) x = in_.number("a pipe's point");
            // In the file: inner and outer diameter, bend radius, place.
            object.solid.numbers.insert(object.solid.numbers.end(), {v[3], v[4], v[5], v[0], v[1], v[2]});
        }
        if (!more_) in_.fail("found the end of the file, wanted END_PIPE");
        database_.add(std::move(object));
        more_ = in_.next_record();
    }

    void arbn() {
        Object object{.place = in_.place()};
        object.name = std::string(in_.wanted_word("an arbn's name"));
        object.solid = {.kind = SolidKind::arbn, .type = "arbn"};
        const long planes = in_.whole("a count of planes");
        for (long i = 0; i < planes; ++i) {
            if (!in_.next_record()) in_.fail("found the end of the file, wanted a plane");
            static_cast<void>(in_.word());
            for (int k = 0; k < 4; ++k) object.solid.numbers.push_back(in_.number("a plane"));
        }
        database_.add(std::move(object));
        more_ = in_.next_record();
    }

    /// s dsp name file="x" w=2 ...: a solid that is told in pairs.
    void fields() {
        static constexpr std::pair<std::string_view, SolidKind> kinds[] = {
            {"dsp", SolidKind::dsp}, {"ebm", SolidKind::ebm}, {"vol", SolidKind::vol}, {"hf", SolidKind::hf}};
        const std::string type(in_.wanted_word("a type"));
        Object object{.name = std::string(in_.wanted_word("a solid's name")), .place = in_.place()};
        object.solid = {.type = type, .fields = fields_of(in_.line())};
        for (const auto& [name, kind] : kinds)
            if (type == name) object.solid.kind = kind;
        finish(std::move(object));
    }

    /// A type name curves points ..., then B records of up to eight points, all but the first told from the first.
    void ars() {
        static_cast<void>(in_.whole("an ars' type"));
        Object object{.name = std::string(in_.wanted_word("an ars' name")), .place = in_.place()};
        const long curves = in_.whole("an ars' curves"), points = in_.whole("an ars' points");
        if (curves < 0 || points < 1) in_.fail(fmt::format("found {} curves of {} points", curves, points));
        object.solid = {.kind = SolidKind::ars, .type = "ars", .points_a_curve = static_cast<std::size_t>(points)};
        std::vector<double>& v = object.solid.numbers;
        for (long curve = 0; curve < curves; ++curve)
            for (long point = 0; point < points; ++point) {
                if (point % 8 == 0) begin_row("B", 3);
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    const double x = in_.number("an ars' point");
                    v.push_back(v.size() < 3 ? x : x + v[axis]);
                }
            }
        finish(std::move(object));
    }

    /// The next record, whose letter is known, over `skipped` words of it.
    void begin_row(const char* letter, int skipped) {
        if (!in_.next_record() || in_.wanted_word("a record's letter") != letter)
            in_.fail(fmt::format("found another record or the end of the file, wanted {}", letter));
        for (int i = 0; i < skipped; ++i) static_cast<void>(in_.wanted_word("a number"));
    }

    /// P name, then Q records: a count of corners, and five places for them.
    void poly() {
        Object object{.name = std::string(in_.wanted_word("a poly's name")), .place = in_.place()};
        object.solid = {.kind = SolidKind::bot, .orientation = 1, .type = "poly"};
        Solid& out = object.solid;
        while ((more_ = in_.next_record()) && in_.line().starts_with("Q ")) {
            static_cast<void>(in_.word());
            const long corners = in_.whole("a count of corners");
            if (corners < 3 || corners > 5) in_.fail(fmt::format("found {} corners, wanted 3 to 5", corners));
            const auto first = static_cast<std::uint32_t>(out.numbers.size() / 3);
            for (long i = 0; i < 3 * corners; ++i) out.numbers.push_back(in_.number("a corner"));
            for (std::uint32_t i = 2; i < static_cast<std::uint32_t>(corners); ++i)
                out.corners.insert(out.corners.end(), {first, first + i - 1, first + i});
        }
        database_.add(std::move(object));
    }

    /// t name mode orientation 0 corners triangles, then rows "number: ...".
    void bot() {
        Object object{.name = std::string(in_.wanted_word("a bot's name")), .place = in_.place()};
        Solid& out = object.solid = {.kind = SolidKind::bot, .type = "bot"};
        out.mode = static_cast<int>(in_.whole("a bot's mode"));
        out.orientation = static_cast<int>(in_.whole("a bot's orientation"));
        static_cast<void>(in_.whole("a bot's errors"));
        const long corners = in_.whole("a count of corners"), triangles = in_.whole("a count of triangles");
        const auto row = [&](const char* what) {
            if (!in_.next_record()) in_.fail(fmt::format("found the end of the file, wanted {}", what));
            static_cast<void>(in_.wanted_word("a number"));
        };
        for (long i = 0; i < corners; ++i) {
            row("a corner");
            for (int k = 0; k < 3; ++k) out.numbers.push_back(in_.number("a corner"));
        }
        for (long i = 0; i < triangles; ++i) {
            row("a triangle");
            for (int k = 0; k < 3; ++k) out.corners.push_back(index_below(corners));
            if (out.mode < 3) continue;
            out.thickness.push_back(in_.number("a thickness"));
            out.appended.push_back(in_.whole("a plate's mode") != 0);
        }
        finish(std::move(object));
    }
    std::uint32_t index_below(long count) {
        const long i = in_.whole("a corner's number");
        if (i < 0 || i >= count) in_.fail(fmt::format("found corner {}, wanted one below {}", i, count));
        return static_cast<std::uint32_t>(i);
    }

    /// d name V A B corners curves, a line of corners, then a curve a line.
    void sketch() {
        Object object{.name = std::string(in_.wanted_word("a sketch's name")), .place = in_.place()};
        Solid& out = object.solid = {.kind = SolidKind::sketch, .type = "sketch"};
        for (int i = 0; i < 9; ++i) out.numbers.push_back(in_.number("a sketch's number"));
        const long corners = in_.whole("a count of corners"), curves = in_.whole("a count of curves");
        if (!in_.next_record()) in_.fail("found the end of the file, wanted a sketch's corners");
        for (long i = 0; i < 2 * corners; ++i) out.numbers.push_back(in_.number("a sketch's corner"));
        for (long i = 0; i < curves; ++i) {
            if (!in_.next_record()) in_.fail("found the end of the file, wanted a sketch's curve");
            out.curves.push_back(curve(corners));
        }
        finish(std::move(object));
    }
    SketchCurve curve(long corners) {
        const std::string kind(in_.wanted_word("a curve's letter"));
        SketchCurve out;
        static_cast<void>(in_.whole("a curve's direction"));
        if (kind == "L" || kind == "A") {
            for (int i = 0; i < 2; ++i) out.corners.push_back(index_below(corners));
            if (kind == "L") return out;
            out.kind = SketchCurve::Kind::arc;
            out.radius = in_.number("an arc's radius");
            out.centre_left = in_.whole("an arc's side") != 0;
            out.clockwise = in_.whole("an arc's direction") != 0;
            return out;
        }
        if (kind != "N") in_.fail(fmt::format("found curve \"{}\", wanted L, A or N", kind.substr(0, 20)));
        out.kind = SketchCurve::Kind::nurb;
        for (const char* what : {"a NURB's order", "a NURB's points"}) static_cast<void>(in_.whole(what));
        const long knots = in_.whole("a count of knots"), points = in_.whole("a count of points");
        begin_row("K", 0);
        for (long i = 0; i < knots; ++i) out.knots.push_back(in_.number("a knot"));
        begin_row("V", 0);
        for (long i = 0; i < points; ++i) out.corners.push_back(index_below(corners));
        return out;
    }

    /// e name sketch key-point V H A B.
    void extrude() {
        Object object{.name = std::string(in_.wanted_word("an extrude's name")), .place = in_.place()};
        object.solid = {.kind = SolidKind::extrude, .type = "extrude"};
        object.solid.sketch = std::string(in_.wanted_word("a sketch's name"));
        static_cast<void>(in_.whole("a key point"));
        for (int i = 0; i < 12; ++i) object.solid.numbers.push_back(in_.number("an extrude's number"));
        finish(std::move(object));
    }

    /// c name V H radius thickness.
    void cline() {
        Object object{.name = std::string(in_.wanted_word("a cline's name")), .place = in_.place()};
        double v[8];
        for (double& x : v) x = in_.number("a cline's number");
        object.solid = {
            .kind = SolidKind::cline, .numbers = {v[7], v[6], v[0], v[1], v[2], v[3], v[4], v[5]}, .type = "cline"};
        finish(std::move(object));
    }

    void finish(Object object) {
        database_.add(std::move(object));
        more_ = in_.next_record();
    }

    /// A solid that is known by name only.
    void named(const std::string& type) {
        Object object{.place = in_.place()};
        object.name = std::string(in_.wanted_word("a solid's name"));
        object.solid.type = type;
        database_.add(std::move(object));
        more_ = in_.next_record();
    }

    LineReader in_;
    Database database_;
    bool more_ = false, warned_ = false;
};

}  // namespace

bool looks_like_text_v4(std::string_view head) {
    return head.size() > 3 && head.starts_with("I ") &&
           head.substr(0, head.find('\n')).find(" v4") != std::string_view::npos;
}

Database read_text_v4(std::string_view text, const std::string& file) { return TextReader(text, file).run(); }

}  // namespace cardioid::formats::brlcad
