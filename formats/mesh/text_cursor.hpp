#pragma once
#include <cstdint>
#include <string>
#include <string_view>

namespace cardioid::formats {

/// Walks through the words of a text file and knows the line it is in. Errors are Error(bad_input) with file:line.
class TextCursor {
public:
    TextCursor(std::string_view text, std::string file, std::size_t line = 1)
        : rest_(text), file_(std::move(file)), line_(line) {}

    /// The next word, or "" at the end of the file.
    std::string_view word();
    /// The next word of this line, or "" at its end; a backslash before the end joins the next line.
    std::string_view word_in_line();
    void skip_line();
    [[nodiscard]] bool at_end() const { return rest_.empty(); }
    [[nodiscard]] std::size_t line() const { return line_; }
    [[nodiscard]] std::string_view rest() const { return rest_; }

    /// The next word as a finite number.
    double number();
    /// A word as a finite number; `wanted` goes into the message.
    double number(std::string_view word, std::string_view wanted = "a number") const;
    /// A word as a whole number.
    std::int64_t integer(std::string_view word, std::string_view wanted) const;
    /// "file:line: found X, wanted Y"; an empty `found` is the end of the line or file.
    [[noreturn]] void fail(std::string_view found, std::string_view wanted) const;
    [[noreturn]] void fail_at(std::size_t line, std::string_view found, std::string_view wanted) const;

private:
    void skip_blanks();
    std::string_view take_word();

    std::string_view rest_;
    std::string file_;
    std::size_t line_;
};

/// A word of a file for a message: in quotes, what cannot be printed as ?, at most 40 bytes of it.
std::string quoted(std::string_view word);

}  // namespace cardioid::formats
