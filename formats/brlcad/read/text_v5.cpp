#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>

#include "formats/brlcad/read/readers.hpp"
#include "formats/brlcad/read/tcl_words.hpp"
#include "formats/brlcad/solid_kinds.hpp"
#include "rt_core/api/error.hpp"
#include "rt_core/scene/nearest_name.hpp"

namespace cardioid::formats::brlcad {

namespace {

/// Braces within braces of a tree that are followed.
constexpr std::size_t deepest_tree = 10'000;

class TextReader {
public:
    TextReader(std::string_view text, const std::string& file)
        : text_(text), file_(file), commands_(text, text, file, 0) {}

    Database run() {
        while (commands_.next_command(words_)) command();
        return std::move(database_);
    }

private:
    [[noreturn]] void fail(std::size_t offset, const std::string& what) const {
        throw Error(ErrorCode::bad_input, commands_.place(offset) + ": " + what);
    }
    const TclWord& word(std::size_t i, const char* what) const {
        if (i < words_.size()) return words_[i];
        fail(words_.back().offset + words_.back().text.size(),
             fmt::format("found the end of \"{}\", wanted {}", words_[0].text.substr(0, 20), what));
    }
    std::vector<TclWord> list_of(const TclWord& w) const { return TclWords(w.text, text_, file_, w.offset).list(); }

    void command() {
        const std::string& name = words_[0].text;
        if (name == "title")
            database_.title = word(1, "a title").text;
        else if (name == "units")
            database_.unit_mm = unit_mm(word(1, "a unit").text);
        else if (name == "put")
            put();
        else if (name == "attr")
            attributes();
        else if (name == "color")
            colour();
        else if (name != "dbupgrade") {
            static constexpr std::string_view known[] = {"title", "units", "put", "attr", "color"};
            fail(words_[0].offset, fmt::format("found command \"{}\", wanted title, units, put, attr or color{}",
                                               name.substr(0, 40), did_you_mean(name, known)));
        }
    }

    void put() {
        Object object{.name = word(1, "a name").text, .place = commands_.place(words_[1].offset)};
        const std::string& type = word(2, "a type").text;
        if (type == "comb")
            object.combination = combination();
        else
            object.solid = solid(type);
        database_.add(std::move(object));
    }

    Solid solid(const std::string& type) const {
        if (type == "pipe") return pipe();
        if (type == "arbn") return arbn();
        if (type == "bot") return bot();
        if (type == "sketch") return sketch();
        if (type == "extrude") return of_sketch(SolidKind::extrude, type, {"V", "H", "A", "B"}, "S");
        if (type == "revolve") return of_sketch(SolidKind::revolve, type, {"V", "axis", "R", "ang"}, "sk_name");
        if (type == "ars") return ars();
        if (type == "metaball") return metaball();
        if (type == "binunif") return data();
        for (const auto& [name, kind] : {std::pair{"dsp", SolidKind::dsp},
                                         {"ebm", SolidKind::ebm},
                                         {"vol", SolidKind::vol},
                                         {"hf", SolidKind::hf}})
            if (type == name) return fields(kind, type);
        const bool is_arb = type == "arb4" || type == "arb5" || type == "arb6" || type == "arb7";
        const SolidRow* row = find_row(is_arb ? "arb8" : type == "sph" ? "ell" : type);
        if (!row) return {.kind = kind_without_body(type), .type = type};
        Solid out{.kind = row->kind, .type = row->name};
        for (const SolidField& field : row->fields) {
            const TclWord* found = value_of(field.name);
            if (!found)
                fail(words_[2].offset,
                     fmt::format("found {} without {}, wanted its {} numbers", type, field.name, field.count));
            append_numbers(*found, static_cast<std::size_t>(field.count), out.numbers);
        }
        return out;
    }

    /// The word behind a key, or null.
    const TclWord* value_of(std::string_view key) const {
        for (std::size_t i = 3; i + 1 < words_.size(); i += 2)
            if (words_[i].text == key) return &words_[i + 1];
        return nullptr;
    }

    double number(const TclWord& w) const {
        const std::string_view text =
            w.text.starts_with('+') ? std::string_view(w.text).substr(1) : std::string_view(w.text);
        double value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (text.empty() || end != text.data() + text.size() || error == std::errc::invalid_argument ||
            !std::isfinite(value))
            fail(w.offset, fmt::format("found \"{}\", wanted a number", w.text.substr(0, 40)));
        return error == std::errc::result_out_of_range ? 0 : value;
    }
    long whole(const TclWord& w) const {
        const double value = number(w);
        if (value != std::floor(value) || std::abs(value) > 4e9)
            fail(w.offset, fmt::format("found \"{}\", wanted a whole number", w.text.substr(0, 40)));
        return static_cast<long>(value);
    }

    /// Numbers of a list within lists; `wanted` of them where it is not 0.
    void append_numbers(const TclWord& w, std::size_t wanted, std::vector<double>& out) const {
        const std::size_t before = out.size();
        for (const TclWord& part : list_of(w)) {
            if (part.text.find(' ') == std::string::npos)
                out.push_back(number(part));
            else
                for (const TclWord& inner : list_of(part)) out.push_back(number(inner));
        }
        if (wanted && out.size() - before != wanted)
            fail(w.offset, fmt::format("found {} numbers, wanted {}", out.size() - before, wanted));
    }

    Solid pipe() const {
        Solid out{.kind = SolidKind::pipe, .type = "pipe"};
        for (int i = 0;; ++i) {
            const TclWord* at = value_of(fmt::format("V{}", i));
            if (!at) return out;
            append_numbers(*at, 3, out.numbers);
            for (const char letter : {'I', 'O', 'R'}) {
                const TclWord* v = value_of(fmt::format("{}{}", letter, i));
                if (!v) fail(at->offset, fmt::format("found V{} without {}{}", i, letter, i));
                out.numbers.push_back(number(*v));
            }
        }
    }

    Solid arbn() const {
        Solid out{.kind = SolidKind::arbn, .type = "arbn"};
        for (int i = 0;; ++i) {
            const TclWord* plane = value_of(fmt::format("P{}", i));
            if (!plane) return out;
            append_numbers(*plane, 4, out.numbers);
        }
    }

    Solid bot() const {
        Solid out{.kind = SolidKind::bot, .type = "bot"};
        static constexpr const char* modes[] = {"surf", "volume", "plate", "plate_nocos"};
        if (const TclWord* mode = value_of("mode"))
            for (int i = 0; i < 4; ++i)
                if (mode->text == modes[i] || (i == 1 && mode->text == "solid")) out.mode = i + 1;
        if (const TclWord* turn = value_of("orient")) {
            if (turn->text == "rh" || turn->text == "ccw") out.orientation = 2;
            if (turn->text == "lh" || turn->text == "cw") out.orientation = 3;
        }
        if (const TclWord* v = value_of("V")) append_numbers(*v, 0, out.numbers);
        if (const TclWord* t = value_of("T"); t && out.mode > 2) append_numbers(*t, 0, out.thickness);
        if (const TclWord* modes_of = value_of("fm"); modes_of && out.mode > 2)
            out.appended = appended_plates(modes_of->text, out.thickness.size());
        if (out.numbers.size() % 3) fail(words_[2].offset, "found corners that are no triples");
        if (const TclWord* f = value_of("F")) {
            std::vector<double> corners;
            append_numbers(*f, 0, corners);
            for (const double c : corners) {
                if (!(c >= 0 && c < static_cast<double>(out.numbers.size() / 3)) || c != std::floor(c))
                    fail(f->offset, fmt::format("found corner {}, wanted one below {}", c, out.numbers.size() / 3));
                out.corners.push_back(static_cast<std::uint32_t>(c));
            }
            if (corners.size() % 3) fail(f->offset, "found triangles that are no triples");
        }
        return out;
    }

    Solid fields(SolidKind kind, const std::string& type) const {
        Solid out{.kind = kind, .type = type};
        for (std::size_t i = 3; i + 1 < words_.size(); i += 2) out.fields[words_[i].text] = words_[i + 1].text;
        return out;
    }

    /// Curves C0 C1 ... of as many points each.
    Solid ars() const {
        Solid out{.kind = SolidKind::ars, .type = "ars"};
        for (int i = 0;; ++i) {
            const TclWord* curve = value_of(fmt::format("C{}", i));
            if (!curve) return out;
            append_numbers(*curve, i ? out.points_a_curve * 3 : 0, out.numbers);
            if (i == 0) out.points_a_curve = out.numbers.size() / 3;
            if (i == 0 && out.numbers.size() % 3) fail(curve->offset, "found points that are no triples");
        }
    }

    /// metaball METHOD THRESHOLD {{x y z strength sharpness} ...}.
    Solid metaball() const {
        Solid out{.kind = SolidKind::metaball, .type = "metaball"};
        out.method = static_cast<int>(std::clamp(whole(word(3, "a metaball's method")), 0L, 255L));
        out.numbers.push_back(number(word(4, "a metaball's threshold")));
        append_numbers(word(5, "a metaball's points"), 0, out.numbers);
        if (out.numbers.size() % 5 != 1) fail(words_[5].offset, "found points that are not of five numbers");
        return out;
    }

    /// Numbers of type T: bytes and words only, which other solids use.
    Solid data() const {
        Solid out{.kind = SolidKind::data, .type = "binunif"};
        const TclWord *type = value_of("T"), *values = value_of("D");
        if (!type || !values) fail(words_[2].offset, "found binunif without T and D");
        static constexpr std::string_view letters = "fdCSILcsil";
        static constexpr int types[] = {2, 3, 4, 5, 6, 7, 12, 13, 14, 15};
        const std::size_t letter = type->text.size() == 1 ? letters.find(type->text[0]) : std::string_view::npos;
        out.element = letter == std::string_view::npos ? static_cast<int>(whole(*type) & 15) : types[letter];
        const int kind = out.element & 7;
        if (kind != 4 && kind != 5) return out;
        for (const TclWord& value : list_of(*values)) {
            const long n = whole(value);
            if (kind == 5) out.bytes += static_cast<char>(n >> 8 & 255);
            out.bytes += static_cast<char>(n & 255);
        }
        return out;
    }

    Solid of_sketch(SolidKind kind, const std::string& type, std::initializer_list<const char*> keys,
                    const char* name) const {
        Solid out{.kind = kind, .type = type};
        for (const char* key : keys) {
            const TclWord* found = value_of(key);
            if (!found) fail(words_[2].offset, fmt::format("found {} without {}", type, key));
            append_numbers(*found, std::string_view(key) == "ang" ? 1 : 3, out.numbers);
        }
        if (const TclWord* found = value_of(name)) out.sketch = found->text;
        return out;
    }

    Solid sketch() const {
        Solid out{.kind = SolidKind::sketch, .type = "sketch"};
        for (const char* key : {"V", "A", "B"}) {
            const TclWord* found = value_of(key);
            if (!found) fail(words_[2].offset, fmt::format("found sketch without {}", key));
            append_numbers(*found, 3, out.numbers);
        }
        if (const TclWord* corners = value_of("VL")) append_numbers(*corners, 0, out.numbers);
        if (out.numbers.size() % 2 == 0) fail(words_[2].offset, "found corners of a sketch that are no pairs");
        const TclWord* list = value_of("SL");
        if (!list) return out;
        for (const TclWord& word : list_of(*list)) {
            const std::vector<TclWord> parts = list_of(word);
            if (parts.empty()) continue;
            const std::string& kind = parts[0].text;
            if (kind != "line" && kind != "carc" && kind != "bezier" && kind != "nurb")
                return {.type = fmt::format("sketch with a curve \"{}\"", kind.substr(0, 20))};
            out.curves.push_back(curve(parts, (out.numbers.size() - 9) / 2));
        }
        return out;
    }

    /// line S 0 E 1; carc S 0 E 1 R 5 L 1 O 0; bezier D 2 P {0 1 2}; nurb O 3 T 5 K {0 0 0 1 1 1} P {0 1 2} W {1 1 1}.
    SketchCurve curve(const std::vector<TclWord>& parts, std::size_t corners) const {
        SketchCurve out;
        if (parts[0].text == "carc") out.kind = SketchCurve::Kind::arc;
        if (parts[0].text == "bezier") out.kind = SketchCurve::Kind::bezier;
        if (parts[0].text == "nurb") out.kind = SketchCurve::Kind::nurb;
        const auto corner = [&](const TclWord& at) {
            const long i = whole(at);
            if (i < 0 || static_cast<std::size_t>(i) >= corners)
                fail(at.offset, fmt::format("found corner {}, wanted one below {}", i, corners));
            out.corners.push_back(static_cast<std::uint32_t>(i));
        };
        for (std::size_t i = 1; i + 1 < parts.size(); i += 2) {
            const std::string& key = parts[i].text;
            if (key == "S" || key == "E") corner(parts[i + 1]);
            if (key == "P")
                for (const TclWord& at : list_of(parts[i + 1])) corner(at);
            if (key == "K") append_numbers(parts[i + 1], 0, out.knots);
            if (key == "W") append_numbers(parts[i + 1], 0, out.weights);
            if (key == "R") out.radius = number(parts[i + 1]);
            if (key == "L") out.centre_left = whole(parts[i + 1]) != 0;
            if (key == "O" && out.kind == SketchCurve::Kind::arc) out.clockwise = whole(parts[i + 1]) != 0;
        }
        if (out.corners.size() < 2) fail(parts[0].offset, "found a curve without both of its ends");
        return out;
    }

    Combination combination() const {
        Combination out;
        for (std::size_t i = 3; i + 1 < words_.size(); i += 2) {
            if (words_[i].text == "tree")
                out.steps = tree(words_[i + 1]);
            else
                set_attribute(out, words_[i].text, words_[i + 1].text);
        }
        return out;
    }

    /// {op left right} within each other, from the outside: a stack of what is still to be written, last first.
    std::vector<Step> tree(const TclWord& whole_tree) const {
        struct Waiting {
            TclWord word;
            std::optional<Step::Op> op;  ///< to be written in place of the word
        };
        std::vector<Step> out;
        std::vector<Waiting> waiting{{whole_tree, std::nullopt}};
        while (!waiting.empty()) {
            if (waiting.size() > deepest_tree) fail(whole_tree.offset, "found a tree of more than 5000 levels");
            const Waiting next = std::move(waiting.back());
            waiting.pop_back();
            if (next.op) {
                out.push_back({*next.op});
                continue;
            }
            std::vector<TclWord> parts = list_of(next.word);
            if (parts.empty()) fail(next.word.offset, "found an empty branch of a tree");
            const std::string op = parts[0].text;
            if (op == "l") {
                out.push_back(member(parts));
                continue;
            }
            const Step::Op step = operation(parts[0]);
            const std::size_t branches = step == Step::Op::complement ? 1 : 2;
            if (parts.size() != 1 + branches)
                fail(parts[0].offset,
                     fmt::format("found {} branches of \"{}\", wanted {}", parts.size() - 1, op, branches));
            waiting.push_back({{}, step});
            for (std::size_t i = branches; i > 0; --i) waiting.push_back({std::move(parts[i]), std::nullopt});
        }
        return out;
    }

    [[nodiscard]] Step::Op operation(const TclWord& w) const {
        if (w.text == "u") return Step::Op::unite;
        if (w.text == "-") return Step::Op::subtract;
        if (w.text == "n" || w.text == "+") return Step::Op::intersect;
        if (w.text == "^") return Step::Op::exclusive;
        if (w.text == "!") return Step::Op::complement;
        fail(w.offset, fmt::format("found operation \"{}\", wanted u, -, n, +, ^, ! or l", w.text.substr(0, 20)));
    }

    [[nodiscard]] Step member(const std::vector<TclWord>& parts) const {
        if (parts.size() < 2) fail(parts[0].offset, "found a member without a name");
        Step out{.name = parts[1].text};
        if (parts.size() < 3) return out;
        std::vector<double> numbers;
        append_numbers(parts[2], 16, numbers);
        out.matrix.emplace();
        std::copy(numbers.begin(), numbers.end(), out.matrix->begin());
        return out;
    }

    void attributes() {
        if (word(1, "set").text != "set") return;
        const std::string& name = word(2, "a name").text;
        const auto found = database_.index.find(name);
        for (std::size_t i = 3; i + 1 < words_.size(); i += 2) {
            if (name == "_GLOBAL")
                set_global(database_, words_[i].text, words_[i + 1].text);
            else if (found != database_.index.end() && database_.objects[found->second].combination)
                set_attribute(*database_.objects[found->second].combination, words_[i].text, words_[i + 1].text);
        }
    }

    void colour() {
        ColourRange range;
        range.low = whole(word(1, "a region's number")), range.high = whole(word(2, "a region's number"));
        for (std::size_t i = 0; i < 3; ++i)
            range.colour[i] = static_cast<std::uint8_t>(std::clamp(whole(word(3 + i, "a colour")), 0L, 255L));
        database_.colours.push_back(range);
    }

    std::string_view text_;
    const std::string& file_;
    TclWords commands_;
    std::vector<TclWord> words_;
    Database database_;
};

}  // namespace

bool looks_like_text_v5(std::string_view head) {
    while (!head.empty() && (head[0] == '#' || head[0] == '\n' || head[0] == '\r'))
        head.remove_prefix(std::min(head.find('\n'), head.size() - 1) + 1);
    return head.starts_with("title {") || head.starts_with("title \"") || head.starts_with("put {") ||
           head.starts_with("put ") || head.starts_with("units ");
}

Database read_text_v5(std::string_view text, const std::string& file) { return TextReader(text, file).run(); }

}  // namespace cardioid::formats::brlcad
