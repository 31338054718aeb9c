#include "tests/models/corpus.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <unistd.h>

#include "cli/builtins.hpp"
#include "cli/io/scene_input.hpp"

namespace cardioid::test {
namespace {

namespace fs = std::filesystem;

/// FNV-1a, 64 bits.
std::uint64_t hash_of(const std::string& text) {
    std::uint64_t hash = 0xcbf29ce484222325U;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
    return hash;
}

constexpr std::array later{"animate"};
constexpr std::array imported{".stl", ".obj", ".ply", ".off", ".amf", ".3mf", ".gltf", ".glb", ".nef3", ".dxf", ".svg"};

/// Reads on over `text` from `at`: what stands between the quotes of the next string.
std::string next_string(const std::string& text, std::size_t at) {
    const std::size_t open = text.find('"', at), close = text.find('"', open + 1);
    return close == std::string::npos ? "" : text.substr(open + 1, close - open - 1);
}

/// What a call at text[at], whose name ends there, needs; "" where it needs nothing that is to come.
std::string need_of(const std::string& name, const std::string& text, std::size_t at) {
    if (std::ranges::find(later, name) != later.end()) return name;
    if (text.compare(at, 8, "(file = ") != 0 || name != "import") return "";
    const std::string extension = cli::extension_of(next_string(text, at));
    if (std::ranges::find(imported, extension) != imported.end()) return "";
    return name + " of " + (extension.empty() ? "a file" : extension.substr(1));
}

const Registry& registry() {
    static const std::unique_ptr<Registry> instance = cli::open_registry({});
    return *instance;
}

}  // namespace

bool has_openscad() {
    static const bool found = std::system("openscad --version >/dev/null 2>&1") == 0;
    return found;
}

bool long_tests() {
    const char* const wish = std::getenv("CARDIOID_LONG_TESTS");
    return wish && std::string(wish) != "0" && *wish;
}

std::vector<fs::path> programs_below(const std::string& folder) {
    std::vector<fs::path> found;
    std::error_code missing;
    for (const auto& entry : fs::recursive_directory_iterator(openscad_share / folder, missing))
        if (entry.path().extension() == ".scad") found.push_back(entry.path());
    std::ranges::sort(found);
    return found;
}

std::optional<fs::path> evaluated(const fs::path& program, const std::string& extension) {
    const fs::path folder = CARDIOID_MODEL_CACHE;
    fs::create_directories(folder);
    const std::uint64_t key = hash_of(program.string() + "\n" + file_text(program));
    const fs::path file = folder / fmt::format("{:016x}{}", key, extension);
    if (!fs::exists(file)) {
        // Tests may run side by side: a file appears whole.
        const fs::path fresh = folder / fmt::format("{:016x}-{}{}", key, getpid(), extension);
        const std::string line = fmt::format("ulimit -t 120; openscad -o '{}' '{}' </dev/null >/dev/null 2>&1",
                                             fresh.string(), program.string());
        if (std::system(line.c_str()) != 0) std::ofstream(fresh, std::ios::trunc).flush();
        if (!fs::exists(fresh)) std::ofstream(fresh).flush();  // openscad's status is 0 even where it writes nothing
        fs::rename(fresh, file);
    }
    if (file_text(file).find_first_not_of(" \t\r\n") == std::string::npos) return std::nullopt;
    return file;
}

Scene read_evaluated(const fs::path& csg, const fs::path& program) {
    ReadOptions options;
    options.registry = &registry();
    options.base_dir = program.parent_path().string();
    options.openscad_facets = true;
    const std::string text = file_text(csg);
    return cli::find_reader(csg.string(), text, registry())->read(text, program.string(), options);
}

std::vector<std::string> nodes_to_come(const std::string& csg) {
    std::vector<std::string> found;
    const auto is_word = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '$';
    };
    std::string word;
    for (std::size_t at = 0; at < csg.size(); ++at) {
        if (is_word(csg[at])) {
            word += csg[at];
            continue;
        }
        if (csg[at] == '(')
            if (const std::string need = need_of(word, csg, at);
                !need.empty() && std::ranges::find(found, need) == found.end())
                found.push_back(need);
        word.clear();
        if (csg[at] == '"')  // over the string, whose quotes are escaped
            for (++at; at < csg.size() && csg[at] != '"'; ++at)
                if (csg[at] == '\\') ++at;
    }
    return found;
}

}  // namespace cardioid::test
