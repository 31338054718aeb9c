#include "cli/io/scene_input.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fmt/format.h>
#include <optional>
#include <sys/stat.h>
#include <utility>

#include "cli/options/values.hpp"
#include "rt_core/api/error.hpp"

namespace cardioid::cli {
namespace {

constexpr std::size_t sniffed_bytes = 4096;

struct FileCloser {
    void operator()(std::FILE* file) const {
        if (file != stdin) std::fclose(file);
    }
};

[[noreturn]] void cannot_read(const std::string& file, const char* why) {
    throw Error(ErrorCode::io, fmt::format("{}: cannot be read: {}", file, why));
}

std::vector<std::string> readable_extensions(const Registry& registry) {
    std::vector<std::string> all;
    for (const Format& format : registry.formats())
        if (format.read) all.insert(all.end(), format.extensions.begin(), format.extensions.end());
    return all;
}

[[noreturn]] void unknown_format(const std::string& file, const Registry& registry) {
    const std::string extension = extension_of(file);
    if (extension == ".stl" || extension == ".obj" || extension == ".ply" || extension == ".off")
        throw Error(ErrorCode::bad_input,
                    fmt::format("{}: found a mesh, wanted a scene; a .csg file that says import(\"{}\"); draws it",
                                file, std::filesystem::path(file).filename().string()));
    const std::vector<std::string> known = readable_extensions(registry);
    throw Error(ErrorCode::bad_input, fmt::format("{}: found no scene, wanted a file of format {}{}", file,
                                                  either(known), suggestion(extension, known)));
}

/// A setting of a format.
struct FormatSetting {
    std::string format, option, value;
};

/// Nothing where the setting is not one of a format.
std::optional<FormatSetting> split_setting(const std::string& setting) {
    const std::size_t dot = setting.find('.'), equals = setting.find('=');
    if (dot == std::string::npos || equals == std::string::npos || equals < dot) return std::nullopt;
    FormatSetting out{setting.substr(0, dot), setting.substr(dot + 1, equals - dot - 1), setting.substr(equals + 1)};
    if (out.format != "brlcad" && out.format != "csg") return std::nullopt;
    return out;
}

/// A .scad file is read as .csg.
std::string_view settings_prefix(const Format& format) {
    return std::string_view(format.name) == "scad" ? "csg" : format.name;
}

}  // namespace

void add_format_settings(Arguments& arguments, SceneOptions& options) {
    arguments.list("--set", "FORMAT.option=value", "An option or limit of a format; cardioid list options names them",
                   options.settings);
}

void add_scene_options(Arguments& arguments, SceneOptions& options, const std::string& positional) {
    arguments.positional(positional, "File to read; - is standard input. Behind it: objects of a database to draw",
                         options.file);
    arguments.more(options.objects);
    arguments.group("Reading the scene");
    arguments.value("--facets", "auto|openscad", "Round things are round (auto), or have OpenSCAD's facets",
                    [&](const std::string& text) {
                        const std::vector<std::string> choices{"auto", "openscad"};
                        options.openscad_facets = to_choice("--facets", text, choices) == "openscad";
                    });
    arguments.value("--smooth-from", "N", "A $fn of at least N is meant to be round [24]",
                    [&](const std::string& text) {
                        options.smooth_from = static_cast<int>(to_integer("--smooth-from", text, 3, 1'000'000));
                    });
    arguments.value("--unknown", "error|warn", "An unknown call ends the reading, or is a group of its children",
                    [&](const std::string& text) {
                        const std::vector<std::string> choices{"error", "warn"};
                        options.unknown_is_warning = to_choice("--unknown", text, choices) == "warn";
                    });
    arguments.text("--base-dir", "DIR", "Where the scene's files are looked for [beside the scene]", options.base_dir);
    arguments.text("--materials", "FILE", "A .csg file of define_material and map_color calls to read before",
                   options.materials);
    arguments.flag("--show-background", "Draw what % marks", options.show_background);
    arguments.list("--plugin", "FILE", "Load a plug-in; may be given again", options.plugins);
}

void take_format_options(SceneOptions& options, std::vector<std::string>& settings, std::string* view) {
    std::erase_if(settings, [&](const std::string& setting) {
        if (!split_setting(setting)) return false;
        options.settings.push_back(setting);
        return true;
    });
    std::error_code ignored;  // of a name that is no file
    if (view && (*view == "-" || extension_of(*view) == ".rt" || std::filesystem::is_regular_file(*view, ignored)))
        options.view_file = std::exchange(*view, {});
}

void keep_scene(const SceneOptions& options, const std::string& output, const char* option) {
    std::error_code ignored;  // of a file that is not there, so not the same
    if (std::filesystem::is_regular_file(output, ignored) && std::filesystem::equivalent(options.file, output, ignored))
        throw Error(ErrorCode::usage,
                    fmt::format("{}: {} is the scene itself and would be overwritten", option, output));
}

std::string extension_of(const std::string& file) {
    std::string extension = std::filesystem::path(file).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

std::string read_text(const std::string& file) {
    std::error_code error;
    if (file != "-" && std::filesystem::is_directory(file, error)) cannot_read(file, "it is a folder");
    const std::unique_ptr<std::FILE, FileCloser> stream(file == "-" ? stdin : std::fopen(file.c_str(), "rb"));
    if (!stream) cannot_read(file, std::strerror(errno));
    std::string text;
    if (struct stat status{}; fstat(fileno(stream.get()), &status) == 0 && S_ISREG(status.st_mode))
        text.reserve(static_cast<std::size_t>(status.st_size));
    char buffer[1 << 16];
    while (const std::size_t n = std::fread(buffer, 1, sizeof buffer, stream.get())) text.append(buffer, n);
    if (std::ferror(stream.get())) cannot_read(file, std::strerror(errno));
    return text;
}

const Format* find_reader(const std::string& file, const std::string& text, const Registry& registry) {
    const std::string extension = file == "-" ? "" : extension_of(file);
    for (const Format& format : registry.formats())
        for (const char* known : format.extensions)
            if (format.read && extension == known) return &format;
    const std::string_view head = std::string_view(text).substr(0, sniffed_bytes);
    for (const Format& format : registry.formats())
        if (format.read && format.sniff && format.sniff(head)) return &format;
    // A stream has no name that could tell more, and our own reader says best what is wrong with it.
    return file == "-" ? find_reader("stdin.csg", text, registry) : nullptr;
}

Scene read_scene(const SceneOptions& options, const std::string& text, const Registry& registry) {
    const std::string name = options.file == "-" ? "<stdin>" : options.file;
    const Format* const format = find_reader(options.file, text, registry);
    if (!format) unknown_format(name, registry);
    ReadOptions read;
    read.registry = &registry;
    read.base_dir = options.base_dir;
    if (!options.materials.empty()) {
        read.materials_text = read_text(options.materials);
        read.materials_file = options.materials;
    }
    read.unknown_is_warning = options.unknown_is_warning;
    read.openscad_facets = options.openscad_facets;
    read.smooth_from = options.smooth_from;
    read.show_background = options.show_background;
    if (!options.objects.empty() && !format->has_objects)
        throw Error(ErrorCode::usage, fmt::format("found \"{}\" after SCENE, wanted one only", options.objects[0]));
    if (!options.view_file.empty() && !format->has_objects)
        throw Error(ErrorCode::usage,
                    fmt::format("--view: found file {}, wanted a view's name: only BRL-CAD databases are "
                                "seen by scripts",
                                options.view_file));
    read.objects = options.objects;
    for (const std::string& setting : options.settings) {
        const auto split = split_setting(setting);
        if (!split)
            throw Error(ErrorCode::usage,
                        fmt::format("--set {}: wanted FORMAT.option=value, such as {}", setting, "csg.minkowski=1e8"));
        if (split->format == settings_prefix(*format)) read.settings.emplace_back(split->option, split->value);
    }
    if (!options.view_file.empty()) {
        read.view_file = options.view_file == "-" ? "<stdin>" : options.view_file;
        read.view_text = read_text(options.view_file);
    }
    return format->read(text, name, read);
}

Scene read_scene(const SceneOptions& options, const Registry& registry) {
    return read_scene(options, read_text(options.file), registry);
}

}  // namespace cardioid::cli
