#include "formats/openscad/syntax/lexer.hpp"

#include <array>
#include <charconv>
#include <cstring>
#include <limits>

#include "formats/openscad/syntax/scan.hpp"
#include "rt_core/api/error.hpp"

namespace cardioid::formats::openscad {
namespace {

void find_lines(std::string_view source, std::vector<Place>& starts) {
    starts.push_back(0);
    const char* const begin = source.data();
    const char* const end = begin + source.size();
    for (const char* p = begin; p < end;) {
        p = static_cast<const char*>(std::memchr(p, '\n', static_cast<std::size_t>(end - p)));
        if (!p) break;
        starts.push_back(static_cast<Place>(++p - begin));
    }
}

}  // namespace

Lexer::Lexer(std::string_view source, Ast& ast, bool single_quotes)
    : source_(source), ast_(ast), single_quotes_(single_quotes) {
    if (source.size() >= std::numeric_limits<Place>::max())
        throw Error(ErrorCode::limit, ast.file + ": larger than 4 GB, which this reader cannot take");
    find_lines(source, ast.line_starts);
    if (source.starts_with("\xEF\xBB\xBF")) pos_ = 3;  // byte order mark
}

void Lexer::skip_space() {
    while (pos_ < source_.size()) {
        const char c = source_[pos_];
        if (c == ' ' || c == '\t' || c == '\n' || c == '\r') {
            ++pos_;
        } else if (c == '\xC2' && at(pos_ + 1) == '\xA0') {  // U+00A0
            pos_ += 2;
        } else if (c == '/' && at(pos_ + 1) == '/') {
            pos_ = std::min(source_.find('\n', pos_), source_.size());
        } else if (c == '/' && at(pos_ + 1) == '*') {
            const std::size_t end = source_.find("*/", pos_ + 2);
            if (end == std::string_view::npos)
                fail(static_cast<Place>(pos_), "found a comment that is not closed, wanted \"*/\"");
            pos_ = end + 2;
        } else {
            return;
        }
    }
}

Token Lexer::next() {
    skip_space();
    const Place place = static_cast<Place>(pos_);
    if (pos_ >= source_.size()) return {TokenKind::end, place, {}};
    const std::string_view rest = source_.substr(pos_);
    const std::size_t word = identifier_length(rest), number = number_length(rest);
    if (number > 0 && number >= word) return number_token(number);  // the longest wins; 0x10 and 1_000 are words
    if (word > 0) {
        pos_ += word;
        return {TokenKind::identifier, place, rest.substr(0, word)};
    }
    if (rest[0] == '"' || (single_quotes_ && rest[0] == '\'')) return text_token(rest[0]);
    const std::size_t length = character_length(rest);
    pos_ += length;
    return {TokenKind::sign, place, rest.substr(0, length)};
}

Token Lexer::number_token(std::size_t length) {
    Token token{TokenKind::number, static_cast<Place>(pos_), source_.substr(pos_, length)};
    const std::string_view s = token.spelling;
    const auto [end, error] = std::from_chars(s.data(), s.data() + s.size(), token.number);
    if (error == std::errc::result_out_of_range) {
        if (is_huge(s)) fail(token, "a number below 1.8e308");
        token.number = 0;  // smaller than the smallest double
    }
    pos_ += length;
    return token;
}

Token Lexer::text_token(char quote) {
    const std::size_t start = pos_;
    text_.clear();
    ++pos_;
    while (pos_ < source_.size() && source_[pos_] != quote) {
        const char c = source_[pos_];
        if (c == '\\' && quote == '"') {
            take_escape();
        } else {
            if (c != '\n') text_.push_back(c);  // OpenSCAD drops a raw newline
            ++pos_;
        }
    }
    const bool closed = pos_ < source_.size();
    if (unescaped_ && quote == '"' && !(closed && closes_as_written(pos_ + 1)))
        take_unescaped(start + 1);
    else if (!closed)
        fail(static_cast<Place>(start), "found a text that is not closed, wanted '\"'");
    ++pos_;
    return {TokenKind::text, static_cast<Place>(start), source_.substr(start, pos_ - start)};
}

/// Whether an argument list may go on behind a text: `)` or `, name =`.
bool Lexer::closes_as_written(std::size_t after) const {
    const auto skip = [&](std::size_t i) { return std::min(source_.find_first_not_of(" \t\r\n", i), source_.size()); };
    after = skip(after);
    if (at(after) == ')') return true;
    if (at(after) != ',') return false;
    after = skip(after + 1);
    const std::size_t word = identifier_length(source_.substr(after));
    return word == 0 ? at(after) == '"' : at(skip(after + word)) == '=';
}

/// FreetypeRenderer prints strings without escapes: the end is the first `", ` before a field that it prints.
void Lexer::take_unescaped(std::size_t start) {
    static constexpr std::array fields = {"size = ",   "spacing = ", "font = ",   "direction = ", "language = ",
                                          "script = ", "halign = ",  "valign = ", "$fn = "};
    for (std::size_t end = source_.find("\", ", start); end != std::string_view::npos;
         end = source_.find("\", ", end + 1)) {
        const std::string_view behind = source_.substr(end + 3, 16);
        for (const char* const field : fields)
            if (behind.starts_with(field)) {
                text_ = source_.substr(start, end - start);
                pos_ = end;
                return;
            }
    }
    fail(static_cast<Place>(start - 1), "found a text that is not closed, wanted '\"'");
}

void Lexer::take_escape() {
    const char c = at(pos_ + 1);
    const std::size_t digits = c == 'x' ? 2 : c == 'u' ? 4 : c == 'U' ? 6 : 0;
    if (digits > 0) {
        const std::string_view hex = source_.substr(std::min(pos_ + 2, source_.size()), digits);
        std::uint32_t code = 0;
        const auto [end, error] = std::from_chars(hex.data(), hex.data() + hex.size(), code, 16);
        const bool whole = hex.size() == digits && error == std::errc{} && end == hex.data() + hex.size();
        if (whole && code <= (c == 'x' ? 0x7FU : 0x10FFFFU)) {
            append_utf8(text_, code);
            pos_ += 2 + digits;
            return;
        }
    }
    switch (c) {
        case 'n':
            text_.push_back('\n');
            break;
        case 't':
            text_.push_back('\t');
            break;
        case 'r':
            text_.push_back('\r');
            break;
        case '\\':
            text_.push_back('\\');
            break;
        case '"':
            text_.push_back('"');
            break;
        default:
            text_.push_back('\\');
            --pos_;  // not an escape: the backslash stands for itself
    }
    pos_ += 2;
}

std::string_view Lexer::angle_path() {
    const std::size_t end = source_.substr(0, source_.find('\n', pos_)).find('>', pos_);
    if (end == std::string_view::npos) fail(static_cast<Place>(pos_), "found a path that is not closed, wanted '>'");
    const std::string_view path = source_.substr(pos_, end - pos_);
    pos_ = end + 1;
    return path;
}

void Lexer::fail(const Token& found, const std::string& wanted) const {
    fail(found.place, "found " + shown(found) + ", wanted " + wanted);
}

void Lexer::fail(Place place, const std::string& message) const {
    throw Error(ErrorCode::bad_input, ast_.where(place) + ": " + message);
}

std::string shown(const Token& token) {
    if (token.kind == TokenKind::end) return "the end of the file";
    constexpr std::size_t longest = 40;
    std::string out = token.kind == TokenKind::text ? "" : "\"";
    for (const char c : token.spelling.substr(0, longest)) {
        const auto byte = static_cast<unsigned char>(c);
        static constexpr char hex[] = "0123456789abcdef";
        if (byte < 0x20 || byte == 0x7F || (byte >= 0x80 && token.spelling.size() == 1))
            out += {'\\', 'x', hex[byte >> 4U], hex[byte & 15U]};
        else
            out.push_back(c);
    }
    if (token.spelling.size() > longest) out += "...";
    return token.kind == TokenKind::text ? out : out + "\"";
}

}  // namespace cardioid::formats::openscad
