#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace cardioid::formats::brlcad {

/// The lines of a text and the words in them, with file:line:column for messages.
class LineReader {
public:
    LineReader(std::string_view text, const std::string& file) : text_(text), file_(&file) {}

    /// Goes to the next line; false at the end.
    bool next_line();
    /// The same, over lines that are empty or comments.
    bool next_record();
    /// The line as it is, without its end.
    [[nodiscard]] std::string_view line() const { return line_; }

    /// The next word, or nothing at the end of the line.
    std::optional<std::string_view> word();
    /// The same; throws Error(bad_input) where there is none, saying what was wanted.
    std::string_view wanted_word(const char* what);
    /// A finite number; throws Error(bad_input).
    double number(const char* what);
    /// A whole number; throws Error(bad_input).
    long whole(const char* what);
    /// A whole number where the line has one more word, else `fallback`.
    long whole_or(const char* what, long fallback);

    [[nodiscard]] std::string place() const;
    [[noreturn]] void fail(const std::string& what) const;

private:
    std::string_view text_, line_;
    const std::string* file_;
    std::size_t next_ = 0, column_ = 0, word_column_ = 0;
    int number_ = 0;
};

}  // namespace cardioid::formats::brlcad
