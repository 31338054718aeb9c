#include "tests/arch/source_tree.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>

namespace cardioid::test {

namespace fs = std::filesystem;

namespace {

/// The rest of `text` behind `word`, and blanks on both sides of it; empty where `text` does not begin with it.
std::string_view after(std::string_view text, std::string_view word) {
    const auto skip_blanks = [&] { text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size())); };
    skip_blanks();
    if (!text.starts_with(word)) return {};
    text.remove_prefix(word.size());
    skip_blanks();
    return text;
}

bool is_source(const fs::path& path) {
    const std::string extension = path.extension().string();
    return extension == ".cpp" || extension == ".hpp" || extension == ".h";
}

bool is_project_folder(const fs::path& folder) {
    const std::string name = folder.filename().string();
    if (name.starts_with('.')) return name == ".ci";
    return name != "build" && !fs::exists(folder / "CMakeCache.txt");
}

}  // namespace

Source parse_source(std::string path, std::string_view text) {
    Source source{.path = std::move(path)};
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        ++source.lines;

        const std::string_view directive = after(line, "#");
        const std::string_view name = after(directive, "include");
        if (name.size() > 1 && (name.front() == '"' || name.front() == '<')) {
            const bool quoted = name.front() == '"';
            const std::size_t close = name.find(quoted ? '"' : '>', 1);
            source.includes.push_back({source.lines, std::string(name.substr(1, close - 1)), quoted});
        }
        if (after(directive, "pragma") == "once" || !after(directive, "ifndef").empty()) source.guarded = true;
    }
    return source;
}

std::vector<Source> read_tree(const fs::path& top) {
    std::vector<Source> sources;
    for (const std::string& room : top_folders(top))
        for (auto entry = fs::recursive_directory_iterator(top / room); entry != fs::end(entry); ++entry) {
            if (entry->is_directory() && !is_project_folder(entry->path())) entry.disable_recursion_pending();
            if (!entry->is_regular_file() || !is_source(entry->path())) continue;
            std::ifstream file(entry->path(), std::ios::binary);
            const std::string text{std::istreambuf_iterator<char>(file), {}};
            sources.push_back(parse_source(fs::relative(entry->path(), top).generic_string(), text));
        }
    std::ranges::sort(sources, {}, &Source::path);
    return sources;
}

std::set<std::string> top_folders(const fs::path& top) {
    std::set<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(top))
        if (entry.is_directory() && is_project_folder(entry.path())) names.insert(entry.path().filename().string());
    return names;
}

}  // namespace cardioid::test
