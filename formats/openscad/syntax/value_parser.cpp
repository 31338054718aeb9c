#include "formats/openscad/syntax/value_parser.hpp"

#include <algorithm>
#include <limits>

#include "formats/openscad/syntax/parser.hpp"
#include "formats/openscad/syntax/scan.hpp"

namespace cardioid::formats::openscad {

Argument ValueParser::argument() {
    Argument out{.place = token_.place};
    long_numbers_ = false;
    if (token_.kind == TokenKind::identifier) {
        word_ = token_;
        advance();
        if (token_.is('=')) {
            out.name = build_.text(word_.spelling);
            advance();
            if (token_.is('=')) program(token_);
        } else {
            has_word_ = true;
        }
    }
    out.value = value();
    out.long_numbers = long_numbers_;
    return out;
}

Value ValueParser::value() {
    for (;;) {
        Value done;
        if (!has_word_ && token_.is('[')) {
            if (open_.size() >= nesting_limit)
                lexer_.fail(token_.place,
                            "found more than " + std::to_string(nesting_limit) + " lists inside one another");
            open_.push_back({pending_.size(), token_.place});
            advance();
            if (!token_.is(']')) continue;
            advance();
            done = close_list();
        } else {
            done = scalar();
        }
        // A finished value may finish the lists around it.
        for (;;) {
            if (open_.empty()) return done;
            pending_.push_back(done);
            if (separator()) break;
            done = close_list();
        }
    }
}

/// Takes what stands behind an element; false where it was the list's end.
bool ValueParser::separator() {
    OpenList& list = open_.back();
    const std::size_t count = pending_.size() - list.first_pending;
    if (token_.is(',') && !list.range) {
        advance();
        if (!token_.is(']')) return true;
    } else if (token_.is(':') && (list.range ? count < 3 : count == 1)) {
        list.range = true;
        advance();
        return true;
    }
    if (!token_.is(']')) unexpected("',' or ']'");
    advance();
    return false;
}

Value ValueParser::close_list() {
    const OpenList list = open_.back();
    open_.pop_back();
    const std::span<const Value> elements = std::span(pending_).subspan(list.first_pending);
    const auto is_number = [](const Value& v) { return v.kind == ValueKind::number; };
    Value out;
    if (!list.range && std::all_of(elements.begin(), elements.end(), is_number))
        out = {ValueKind::numbers, elements.empty() ? 0 : elements[0].first,
               static_cast<std::uint32_t>(elements.size())};  // they were stored one behind another
    else
        out = build_.list(elements, list.range ? ValueKind::range : ValueKind::list);
    pending_.resize(list.first_pending);
    return out;
}

Value ValueParser::scalar() {
    if (has_word_) {
        has_word_ = false;
        return word(word_, false);
    }
    bool negative = false, sign = false;
    for (; token_.is('-') || token_.is('+'); advance()) {
        sign = true;
        negative ^= token_.is('-');
    }
    const Token token = token_;
    if (token.kind == TokenKind::number) {
        long_numbers_ = long_numbers_ || is_long_fraction(token.spelling);
        advance();
        return build_.number(negative ? -token.number : token.number);
    }
    if (token.kind == TokenKind::identifier) {
        advance();
        if (sign && token.spelling != "inf" && token.spelling != "nan") program(token);
        return word(token, negative);
    }
    if (sign) lexer_.fail(token, "a number");
    if (token.kind == TokenKind::text) {
        const Value out = build_.string(lexer_.text());
        advance();
        return out;
    }
    if (token.is('(') || token.is('!') || token.is('{')) program(token);
    lexer_.fail(token, "a value");
}

Value ValueParser::word(Token token, bool negative) {
    const std::string_view s = token.spelling;
    if (s == "true" || s == "false") return AstBuilder::boolean(s == "true");
    if (s == "undef") return {};
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (s == "inf") return build_.number(negative ? -infinity : infinity);
    if (s == "nan") return build_.number(std::numeric_limits<double>::quiet_NaN());
    if (s == "function" && token_.is('(')) {
        skip_function();
        return {ValueKind::function, 0, 0};
    }
    if (token_.is('(') || s == "for" || s == "let" || s == "each" || s == "if") program(token);
    return {ValueKind::identifier, build_.text(s), 0};
}

/// Skips `( parameters ) expression` up to the ',' ']' or ')' that ends the value.
void ValueParser::skip_function() {
    const Token start = token_;
    std::size_t depth = 0;
    bool parameters = false;  // seen
    for (;;) {
        if (token_.kind == TokenKind::end) lexer_.fail(start, "a function literal that ends");
        const bool opens = token_.is('(') || token_.is('[') || token_.is('{');
        const bool closes = token_.is(')') || token_.is(']') || token_.is('}');
        if (parameters && depth == 0 && (closes || token_.is(',') || token_.is(';'))) return;
        if (opens) ++depth;
        if (closes && --depth == 0) parameters = true;
        advance();
    }
}

void ValueParser::program(const Token& found) const {
    lexer_.fail(found.place, "found " + shown(found) +
                                 ": this is an OpenSCAD program: run openscad -o m.csg m.scad and give the .csg");
}

void ValueParser::unexpected(const std::string& wanted) const {
    static constexpr std::string_view operators = "+-*/%^<>=!&|?.([";
    if (token_.kind == TokenKind::sign && token_.spelling.size() == 1 &&
        operators.find(token_.spelling[0]) != std::string_view::npos)
        program(token_);
    lexer_.fail(token_, wanted);
}

}  // namespace cardioid::formats::openscad
