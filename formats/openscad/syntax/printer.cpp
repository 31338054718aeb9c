#include "formats/openscad/syntax/printer.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace cardioid::formats::openscad {
namespace {

constexpr std::size_t deepest_indent = 100;  // else a chain of n calls would print n * n tabs

class Printer {
public:
    explicit Printer(const Ast& ast) : ast_(ast) {}

    std::string run() {
        open(ast_.roots);
        while (!calls_.empty()) {
            if (calls_.back().empty()) {
                calls_.pop_back();
                if (!calls_.empty()) indent("}\n");
                continue;
            }
            const Call& call = ast_.calls[calls_.back().front()];
            calls_.back() = calls_.back().subspan(1);
            head(call);
            if (call.child_count > 0) open(ast_.children_of(call));
        }
        return std::move(out_);
    }

private:
    void open(std::span<const std::uint32_t> calls) { calls_.push_back(calls); }

    void indent(const char* text) {
        out_.append(std::min(calls_.size() - 1, deepest_indent), '\t');
        out_ += text;
    }

    void head(const Call& call) {
        for (const auto& [bit, sign] : {std::pair{Modifier::only, '!'}, std::pair{Modifier::disabled, '*'},
                                        std::pair{Modifier::background, '%'}, std::pair{Modifier::highlight, '#'}})
            if ((call.modifiers & bit) != 0) out_.push_back(sign);
        indent(ast_.name(call).c_str());
        out_.push_back('(');
        bool comma = false;
        for (const Argument& argument : ast_.arguments_of(call)) {
            if (comma) out_ += ", ";
            comma = true;
            if (argument.name != Argument::no_name) out_ += ast_.texts[argument.name] + " = ";
            value(argument.value);
        }
        out_ += call.child_count > 0 ? ") {\n" : ");\n";
    }

    struct OpenList {
        std::span<const Value> rest;
        const char* separator;
    };

    /// A value; lists inside lists wait on a stack.
    void value(const Value& first) {
        std::vector<OpenList> lists;
        if (const OpenList* list = element(first)) lists.push_back(*list);
        while (!lists.empty()) {
            OpenList& list = lists.back();
            if (list.rest.empty()) {
                out_.push_back(']');
                lists.pop_back();
                if (!lists.empty() && !lists.back().rest.empty()) out_ += lists.back().separator;
                continue;
            }
            const Value& v = list.rest[0];
            list.rest = list.rest.subspan(1);
            const bool more = !list.rest.empty();
            const char* const separator = list.separator;
            if (const OpenList* inner = element(v))
                lists.push_back(*inner);
            else if (more)
                out_ += separator;
        }
    }

    /// Prints all but a list of values, of which it prints the bracket and returns what is to follow.
    const OpenList* element(const Value& v) {
        switch (v.kind) {
            case ValueKind::undef:
                out_ += "undef";
                break;
            case ValueKind::boolean:
                out_ += v.count != 0 ? "true" : "false";
                break;
            case ValueKind::number:
                number(ast_.numbers[v.first]);
                break;
            case ValueKind::text:
                text(ast_.texts[v.first]);
                break;
            case ValueKind::identifier:
                out_ += ast_.texts[v.first];
                break;
            case ValueKind::numbers:
                numbers(ast_.numbers_of(v));
                break;
            case ValueKind::function:
                out_ += "function() undef";
                break;
            case ValueKind::list:
            case ValueKind::range:
                out_.push_back('[');
                next_ = {ast_.values_of(v), v.kind == ValueKind::range ? " : " : ", "};
                return &next_;
        }
        return nullptr;
    }

    void numbers(std::span<const double> xs) {
        out_.push_back('[');
        for (std::size_t i = 0; i < xs.size(); ++i) {
            if (i > 0) out_ += ", ";
            number(xs[i]);
        }
        out_.push_back(']');
    }

    void number(double x) {
        if (std::isnan(x)) {
            out_ += "nan";
        } else if (std::isinf(x)) {
            out_ += x < 0 ? "-inf" : "inf";
        } else {
            char buffer[32];
            const auto end = std::to_chars(buffer, buffer + sizeof buffer, x).ptr;
            out_.append(buffer, end);
        }
    }

    void text(const std::string& s) {
        out_.push_back('"');
        for (const char c : s) {
            static constexpr char hex[] = "0123456789abcdef";
            const auto byte = static_cast<unsigned char>(c);
            if (c == '"' || c == '\\')
                out_ += {'\\', c};
            else if (c == '\n' || c == '\t' || c == '\r')
                out_ += {'\\', c == '\n' ? 'n' : c == '\t' ? 't' : 'r'};
            else if (byte < 0x20 || byte == 0x7F)
                out_ += {'\\', 'x', hex[byte >> 4U], hex[byte & 15U]};
            else
                out_.push_back(c);
        }
        out_.push_back('"');
    }

    const Ast& ast_;
    std::string out_;
    std::vector<std::span<const std::uint32_t>> calls_;  ///< of each open call, the children still to come
    OpenList next_{};
};

}  // namespace

std::string print(const Ast& ast) { return Printer(ast).run(); }

}  // namespace cardioid::formats::openscad
