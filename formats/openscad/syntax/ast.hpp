#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace cardioid::formats::openscad {

/// Offset of a byte in the text; Ast::where() makes file:line:column of it.
using Place = std::uint32_t;

enum class ValueKind : std::uint8_t {
    undef,
    boolean,     ///< count is 0 or 1
    number,      ///< Ast::numbers[first]
    text,        ///< Ast::texts[first]
    identifier,  ///< a bare word, Ast::texts[first]
    numbers,     ///< a list of numbers only, Ast::numbers[first .. first + count)
    list,        ///< any other list, Ast::values[first .. first + count)
    range,       ///< [a : b] or [a : b : c], Ast::values[first .. first + count)
    function     ///< a function literal; what it says is not kept
};

struct Value {
    ValueKind kind = ValueKind::undef;
    std::uint32_t first = 0, count = 0;
    bool operator==(const Value&) const = default;
};

struct Argument {
    static constexpr std::uint32_t no_name = 0xFFFFFFFFU;
    std::uint32_t name = no_name;  ///< Ast::texts
    Place place = 0;
    Value value;
    bool long_numbers = false;  ///< a fraction in it has more than OpenSCAD's 6 significant digits
};

/// Bits of Call::modifiers.
enum Modifier : std::uint8_t { background = 1, highlight = 2, only = 4, disabled = 8 };

/// name(arguments) with children; the ranges are of Ast::arguments and Ast::children.
struct Call {
    std::uint32_t name = 0;  ///< Ast::texts
    Place place = 0;
    std::uint32_t first_argument = 0, argument_count = 0;
    std::uint32_t first_child = 0, child_count = 0;
    std::uint8_t modifiers = 0;
};

/// A parsed file as flat arrays. Calls stand in document order, so a parent stands before its children.
struct Ast {
    std::string file;    ///< for messages
    std::string origin;  ///< where() of everything in the text of a marker; empty for a file
    std::vector<Call> calls;
    std::vector<std::uint32_t> children;  ///< indices into calls
    std::vector<std::uint32_t> roots;     ///< indices into calls
    std::vector<Argument> arguments;
    std::vector<Value> values;
    std::vector<double> numbers;
    std::vector<std::string> texts;  ///< each once
    std::vector<Place> line_starts;

    [[nodiscard]] const std::string& name(const Call& call) const { return texts[call.name]; }
    [[nodiscard]] std::span<const Argument> arguments_of(const Call& call) const {
        return std::span(arguments).subspan(call.first_argument, call.argument_count);
    }
    [[nodiscard]] std::span<const std::uint32_t> children_of(const Call& call) const {
        return std::span(children).subspan(call.first_child, call.child_count);
    }
    /// The elements of a ValueKind::numbers.
    [[nodiscard]] std::span<const double> numbers_of(const Value& value) const {
        return std::span(numbers).subspan(value.first, value.count);
    }
    /// The elements of a ValueKind::list or range.
    [[nodiscard]] std::span<const Value> values_of(const Value& value) const {
        return std::span(values).subspan(value.first, value.count);
    }
    [[nodiscard]] std::uint32_t line(Place place) const;  ///< from 1; 0 in the text of a marker
    /// "file:line:column", both from 1, columns in bytes.
    [[nodiscard]] std::string where(Place place) const;
};

/// The same calls, arguments and values in the same order; places do not count, any two NaN are equal.
bool equal(const Ast& a, const Ast& b);

/// Fills an Ast in document order.
class AstBuilder {
public:
    explicit AstBuilder(Ast& ast) : ast_(ast) {}
    std::uint32_t text(std::string_view text);  ///< its index; the same text has the same index

    /// Begins a call; its arguments come before its children, then close().
    std::uint32_t open(std::string_view name, Place place = 0, std::uint8_t modifiers = 0);
    void close();
    [[nodiscard]] std::size_t depth() const { return open_.size(); }
    [[nodiscard]] const Call& innermost() const { return ast_.calls[open_.back().call]; }

    void argument(std::string_view name, const Value& value);  ///< "": positional
    void add(const Argument& argument);
    Value number(double x);
    Value numbers(std::span<const double> xs);
    Value list(std::span<const Value> elements, ValueKind kind = ValueKind::list);
    Value string(std::string_view s) { return {ValueKind::text, text(s), 0}; }
    static Value boolean(bool b) { return {ValueKind::boolean, 0, b ? 1U : 0U}; }

private:
    struct Open {
        std::uint32_t call;
        std::size_t first_pending;
    };
    Ast& ast_;
    std::vector<Open> open_;
    std::vector<std::uint32_t> pending_;  ///< finished children of the open calls
    std::unordered_map<std::string, std::uint32_t> index_;
};

}  // namespace cardioid::formats::openscad
