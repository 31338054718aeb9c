#include "formats/openscad/syntax/parser.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "formats/openscad/syntax/lexer.hpp"
#include "formats/openscad/syntax/value_parser.hpp"
#include "rt_core/api/error.hpp"

namespace cardioid::formats::openscad {
namespace {

bool is_program_word(std::string_view word) {
    static constexpr std::array words = {"module", "function", "if",     "else", "for",
                                         "let",    "each",     "assert", "echo", "intersection_for"};
    return std::find(words.begin(), words.end(), word) != words.end();
}

std::uint8_t modifier_bit(const Token& token) {
    if (token.kind != TokenKind::sign || token.spelling.size() != 1) return 0;
    switch (token.spelling[0]) {
        case '%':
            return Modifier::background;
        case '#':
            return Modifier::highlight;
        case '!':
            return Modifier::only;
        case '*':
            return Modifier::disabled;
        default:
            return 0;
    }
}

/// Statements, with a stack of the calls that are open instead of recursion.
class Parser {
public:
    Parser(std::string_view text, Ast& ast, bool marker, std::size_t most_nested)
        : ast_(ast),
          lexer_(text, ast, marker),
          build_(ast),
          values_(lexer_, build_, token_),
          marker_(marker),
          most_nested_(most_nested) {}

    void run() {
        token_ = lexer_.next();
        while (token_.kind != TokenKind::end) statement();
        if (!blocks_.empty()) {
            const Call& open = build_.innermost();
            lexer_.fail(token_, "'}' for " + ast_.name(open) + "() of line " + std::to_string(ast_.line(open.place)));
        }
        if (marker_ && ast_.roots.size() != 1) lexer_.fail(token_, "one call");
    }

private:
    void statement() {
        if (token_.is(';')) {
            advance();
        } else if (token_.is('}') && !blocks_.empty()) {
            advance();
            finish_call();
        } else {
            call();
        }
    }

    void advance() { token_ = lexer_.next(); }

    /// Closes the innermost call, and those around it that have it as their only child.
    void finish_call() {
        blocks_.pop_back();
        build_.close();
        while (!blocks_.empty() && !blocks_.back()) {
            blocks_.pop_back();
            build_.close();
        }
    }

    void call() {
        const Place start = token_.place;
        std::uint8_t modifiers = 0;
        while (const std::uint8_t bit = modifier_bit(token_)) {
            modifiers |= bit;
            advance();
        }
        if (token_.kind != TokenKind::identifier) lexer_.fail(token_, "a call");
        const Token name = token_;
        advance();
        if (name.spelling == "use" || name.spelling == "include") return library(name);
        if (is_program_word(name.spelling) || token_.is('=')) values_.program(name);
        if (blocks_.size() > most_nested_)
            lexer_.fail(start, "found more than " + std::to_string(most_nested_) +
                                   " calls inside one another; --set csg.nesting allows more");
        build_.open(name.spelling, modifiers != 0 ? start : name.place, modifiers);
        blocks_.push_back(true);
        arguments(name);
        behind_arguments();
    }

    void arguments(const Token& name) {
        if (marker_ && token_.kind == TokenKind::end) return;  // `@cardioid end`
        if (!token_.is('(')) lexer_.fail(token_, "'(' behind \"" + std::string(name.spelling) + "\"");
        lexer_.set_unescaped(name.spelling == "text" && !marker_);
        advance();
        bool comma = false;
        while (token_.is(',')) advance();  // leading commas are legal
        while (!token_.is(')') || comma) {
            build_.add(values_.argument());
            comma = token_.is(',');
            if (!comma && !token_.is(')')) values_.unexpected("',' or ')'");
            while (token_.is(',')) advance();
        }
        lexer_.set_unescaped(false);
        advance();
    }

    void behind_arguments() {
        if (token_.is(';') || (marker_ && token_.kind == TokenKind::end)) {
            if (token_.is(';')) advance();
            finish_call();
        } else if (token_.is('{')) {
            advance();
        } else if (modifier_bit(token_) != 0 || token_.kind == TokenKind::identifier) {
            blocks_.back() = false;  // the next statement is its only child
        } else {
            lexer_.fail(token_, "';', '{' or a call");
        }
    }

    /// `use <cardioid.scad>` is for OpenSCAD and means nothing here; any other library is a program.
    void library(const Token& word) {
        if (!token_.is('<')) values_.program(word);
        const std::string_view path = lexer_.angle_path();
        if (path != "cardioid.scad" && !path.ends_with("/cardioid.scad")) values_.program(word);
        advance();
        if (!blocks_.empty() && !blocks_.back()) lexer_.fail(token_, "a call before it");
    }

    Ast& ast_;
    Lexer lexer_;
    AstBuilder build_;
    Token token_;
    ValueParser values_;
    std::vector<bool> blocks_;  ///< of each open call: has it braces, or the next statement as its only child
    bool marker_;
    std::size_t most_nested_;
};

}  // namespace

Ast parse(std::string_view text, std::string file, std::size_t most_nested) {
    Ast ast;
    ast.file = std::move(file);
    Parser(text, ast, false, most_nested).run();
    return ast;
}

Ast parse_marker(std::string_view text, std::string where) {
    Ast ast;
    ast.origin = std::move(where);
    Parser(text, ast, true, nesting_limit).run();
    return ast;
}

}  // namespace cardioid::formats::openscad
