#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace cardioid::formats::brlcad {

/// A word of a list and where it begins in the text.
struct TclWord {
    std::string text;  ///< without its braces or quotes
    std::size_t offset = 0;
};

/// Commands of a text in Tcl's syntax, as `g2asc` writes them: words in braces (nested), in quotes or bare, ended by a
/// line's end or a semicolon; comments begin with #. Nothing is substituted but backslashes outside of braces.
class TclWords {
public:
    /// `offset` of the text in the file and the file's whole text are for messages.
    TclWords(std::string_view text, std::string_view whole, const std::string& file, std::size_t offset)
        : text_(text), whole_(whole), file_(&file), offset_(offset) {}

    /// The words of the next command; false at the end. Throws Error(bad_input) where a brace or quote is open.
    bool next_command(std::vector<TclWord>& words);
    /// All words, over the ends of lines: a list.
    std::vector<TclWord> list();

    /// "file:line:column" of a byte of the file.
    [[nodiscard]] std::string place(std::size_t offset) const;

private:
    /// A semicolon is a letter within a list.
    TclWord word(bool in_list);
    TclWord braced();
    TclWord quoted();

    std::string_view text_, whole_;
    const std::string* file_;
    std::size_t offset_, at_ = 0;
};

}  // namespace cardioid::formats::brlcad
