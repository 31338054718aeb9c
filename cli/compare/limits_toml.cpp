#include "cli/compare/limits_toml.hpp"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <sstream>

#include "rt_core/api/error.hpp"

namespace cardioid::cli {
namespace {

using Json = nlohmann::json;

std::string trimmed(const std::string& text) {
    const auto space = [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; };
    const auto first = std::find_if_not(text.begin(), text.end(), space);
    const auto last = std::find_if_not(text.rbegin(), std::make_reverse_iterator(first), space).base();
    return {first, last};
}

/// Where the first of these characters stands that is in no quotes; npos where none does.
std::size_t find_bare(const std::string& text, char wanted) {
    char quote = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (quote == 0 && text[i] == wanted) return i;
        if (quote != 0 && text[i] == '\\' && quote == '"')
            ++i;
        else if (text[i] == quote)
            quote = 0;
        else if (quote == 0 && (text[i] == '"' || text[i] == '\''))
            quote = text[i];
    }
    return std::string::npos;
}

class Lines {
public:
    explicit Lines(const std::string& path) : path_(path) {}

    Json read(const std::string& text) {
        Json root = Json::object(), *table = &root;
        std::istringstream lines(text);
        for (std::string line; std::getline(lines, line);) {
            ++number_;
            line = trimmed(line.substr(0, find_bare(line, '#')));
            if (line.empty()) continue;
            if (line.front() == '[')
                table = &open_table(root, line);
            else
                add_entry(*table, line);
        }
        return root;
    }

private:
    [[noreturn]] void fail(const std::string& found, const char* wanted) const {
        throw Error(ErrorCode::bad_input, fmt::format("{}:{}: found \"{}\", wanted {}", path_, number_, found, wanted));
    }

    [[nodiscard]] std::string key(const std::string& text) const {
        if (text.size() >= 2 && (text.front() == '"' || text.front() == '\'') && text.back() == text.front())
            return text.substr(1, text.size() - 2);
        const auto bare = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '-'; };
        if (text.empty() || !std::all_of(text.begin(), text.end(), bare)) fail(text, "a name, bare or in quotes");
        return text;
    }

    Json& open_table(Json& root, const std::string& line) const {
        if (line.back() != ']') fail(line, "[table]");
        Json& table = root[key(trimmed(line.substr(1, line.size() - 2)))];
        if (!table.is_null()) fail(line, "a table that is not there yet");
        return table = Json::object();
    }

    void add_entry(Json& table, const std::string& line) const {
        const std::size_t equals = find_bare(line, '=');
        if (equals == std::string::npos) fail(line, "[table] or name = value");
        const std::string name = key(trimmed(line.substr(0, equals)));
        if (table.contains(name)) fail(name, "each name once");
        table[name] = value(trimmed(line.substr(equals + 1)));
    }

    /// Values on one line are written as in JSON, but for texts in single quotes.
    [[nodiscard]] Json value(const std::string& text) const {
        if (text.size() >= 2 && text.front() == '\'' && text.back() == '\'') return text.substr(1, text.size() - 2);
        const Json json = Json::parse(text, nullptr, false);
        if (json.is_discarded() || json.is_null() || json.is_object())
            fail(text, "a number, true, false, \"text\" or [a, b, ...] on one line");
        return json;
    }

    const std::string& path_;
    int number_ = 0;
};

}  // namespace

Json parse_limits_toml(const std::string& path, const std::string& text) { return Lines(path).read(text); }

}  // namespace cardioid::cli
