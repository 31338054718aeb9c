#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "formats/openscad/syntax/ast.hpp"

namespace cardioid::formats::openscad {

enum class TokenKind : std::uint8_t { end, identifier, number, text, sign };

/// The next piece of a file. `spelling` points into the source; of a text, Lexer::text() has what it means.
struct Token {
    TokenKind kind = TokenKind::end;
    Place place = 0;
    std::string_view spelling;
    double number = 0;
    bool is(char c) const { return kind == TokenKind::sign && spelling.size() == 1 && spelling[0] == c; }
};

/// Cuts a source into tokens. Throws Error(bad_input) at unclosed texts and comments and at numbers too large.
class Lexer {
public:
    /// `ast` gets the line starts, and names the file in messages. single_quotes: 'text' is a text too (markers).
    Lexer(std::string_view source, Ast& ast, bool single_quotes);
    Token next();
    /// The text of the last text token, escapes resolved.
    [[nodiscard]] const std::string& text() const { return text_; }
    /// Inside text(...), where OpenSCAD writes strings without escapes: their end is then guessed by what follows.
    void set_unescaped(bool on) { unescaped_ = on; }
    /// Skips to behind the next '>'; what stood between '<' and '>'.
    std::string_view angle_path();
    /// Throws Error(bad_input) "file:line:column: found <found>, wanted <wanted>".
    [[noreturn]] void fail(const Token& found, const std::string& wanted) const;
    [[noreturn]] void fail(Place place, const std::string& message) const;

private:
    void skip_space();
    Token number_token(std::size_t length);
    Token text_token(char quote);
    bool closes_as_written(std::size_t after) const;
    void take_unescaped(std::size_t start);
    void take_escape();
    [[nodiscard]] char at(std::size_t i) const { return i < source_.size() ? source_[i] : '\0'; }

    std::string_view source_;
    const Ast& ast_;
    std::size_t pos_ = 0;
    std::string text_;
    bool single_quotes_;
    bool unescaped_ = false;
};

/// How a token is named in a message: quoted, control characters escaped, cut where it is long.
std::string shown(const Token& token);

}  // namespace cardioid::formats::openscad
