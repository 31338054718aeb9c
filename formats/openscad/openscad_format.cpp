#include "formats/openscad/openscad_format.hpp"

#include <array>
#include <filesystem>

#include "formats/openscad/evaluate/call_table.hpp"
#include "formats/openscad/evaluate/evaluator.hpp"
#include "formats/openscad/limits.hpp"
#include "formats/openscad/run_openscad.hpp"
#include "formats/openscad/scene_writer.hpp"
#include "formats/openscad/syntax/parser.hpp"
#include "formats/openscad/syntax/scan.hpp"

namespace cardioid::formats {
namespace {

std::string folder_of(const std::string& file) {
    const std::string folder = std::filesystem::path(file).parent_path().string();
    return folder.empty() ? "." : folder;
}

Scene read_csg(const std::string& text, const std::string& file, const ReadOptions& options) {
    const openscad::Ast ast = openscad::parse(text, file, openscad::limits_of(options).nesting);
    if (ast.calls.empty())
        throw Error(ErrorCode::bad_input, file + ":1:1: found an empty file, wanted calls such as sphere(r = 1);");
    return openscad::evaluate(ast, options, options.base_dir.empty() ? folder_of(file) : options.base_dir);
}

Scene read_scad(const std::string& text, const std::string& file, const ReadOptions& options) {
    const openscad::Evaluated evaluated = openscad::run_openscad(text, file);
    ReadOptions inner = options;
    if (inner.base_dir.empty()) inner.base_dir = folder_of(file);
    Scene scene = read_csg(evaluated.csg, file + " (evaluated)", inner);
    scene.file = file;
    scene.warnings.insert(scene.warnings.begin(), evaluated.warnings.begin(), evaluated.warnings.end());
    return scene;
}

/// Whether the first word of a file, behind space and comments, is a call of the language.
bool looks_like_csg(std::string_view head) {
    for (;;) {
        const std::size_t start = head.find_first_not_of(" \t\r\n%#!*");
        if (start == std::string_view::npos) return false;
        head.remove_prefix(start);
        if (!head.starts_with("//")) break;
        head.remove_prefix(std::min(head.find('\n'), head.size()));
    }
    const std::size_t word = openscad::identifier_length(head);
    return word > 0 && openscad::find_call(head.substr(0, word)) && head.substr(word).starts_with('(');
}

constexpr std::array csg_extensions = {".csg"};
constexpr std::array scad_extensions = {".scad"};

}  // namespace

const Format csg_format{"csg",          "OpenSCAD's evaluated language with materials, lights and cameras",
                        csg_extensions, looks_like_csg,
                        read_csg,       openscad::write_scene};

const Format scad_format{"scad",          "OpenSCAD programs, evaluated by openscad where it is installed",
                         scad_extensions, nullptr,
                         read_scad,       nullptr};

}  // namespace cardioid::formats
