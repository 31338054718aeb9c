#include "formats/brlcad/read/tcl_words.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "rt_core/api/error.hpp"

namespace cardioid::formats::brlcad {

namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }
bool ends_command(char c) { return c == '\n' || c == ';'; }
bool ends_word(char c, bool in_list) { return is_blank(c) || c == '\n' || (c == ';' && !in_list); }

}  // namespace

bool TclWords::next_command(std::vector<TclWord>& words) {
    words.clear();
    while (at_ < text_.size()) {
        const char c = text_[at_];
        if (is_blank(c)) {
            ++at_;
        } else if (c == '\\' && at_ + 1 < text_.size() && text_[at_ + 1] == '\n') {
            at_ += 2;
        } else if (ends_command(c)) {
            ++at_;
            if (!words.empty()) return true;
        } else if (c == '#' && words.empty()) {
            at_ = std::min(text_.find('\n', at_), text_.size());
        } else {
            words.push_back(word(false));
        }
    }
    return !words.empty();
}

std::vector<TclWord> TclWords::list() {
    std::vector<TclWord> words;
    while (at_ < text_.size()) {
        if (is_blank(text_[at_]) || text_[at_] == '\n')
            ++at_;
        else
            words.push_back(word(true));
    }
    return words;
}

TclWord TclWords::word(bool in_list) {
    if (text_[at_] == '{') return braced();
    if (text_[at_] == '"') return quoted();
    TclWord out{{}, offset_ + at_};
    for (; at_ < text_.size() && !ends_word(text_[at_], in_list); ++at_) {
        if (text_[at_] == '\\' && at_ + 1 < text_.size()) ++at_;
        out.text += text_[at_];
    }
    return out;
}

TclWord TclWords::braced() {
    const std::size_t start = at_++;
    int depth = 1;
    for (; at_ < text_.size(); ++at_) {
        if (text_[at_] == '\\')
            ++at_;
        else if (text_[at_] == '{')
            ++depth;
        else if (text_[at_] == '}' && --depth == 0)
            return {std::string(text_.substr(start + 1, at_++ - start - 1)), offset_ + start + 1};
    }
    throw Error(ErrorCode::bad_input, place(offset_ + start) + ": found no end of what this brace begins, wanted }");
}

TclWord TclWords::quoted() {
    const std::size_t start = at_++;
    TclWord out{{}, offset_ + start + 1};
    for (; at_ < text_.size(); ++at_) {
        if (text_[at_] == '"') {
            ++at_;
            return out;
        }
        if (text_[at_] == '\\' && at_ + 1 < text_.size()) ++at_;
        out.text += text_[at_];
    }
    throw Error(ErrorCode::bad_input, place(offset_ + start) + ": found no end of this text, wanted \"");
}

std::string TclWords::place(std::size_t offset) const {
    const std::string_view before = whole_.substr(0, std::min(offset, whole_.size()));
    const auto lines = std::count(before.begin(), before.end(), '\n');
    const std::size_t start = before.rfind('\n');
    return fmt::format("{}:{}:{}", *file_, lines + 1,
                       before.size() - (start == std::string_view::npos ? 0 : start + 1) + 1);
}

}  // namespace cardioid::formats::brlcad
