#include "formats/openscad/geometry/plane_files.hpp"

#include <cmath>
#include <filesystem>

#include "formats/figure/figure_file.hpp"
#include "formats/mesh/mesh_file.hpp"

namespace cardioid::formats::openscad {
namespace {

std::string file_name(const Arguments& args) { return args.text(args.has("file") ? "file" : "filename"); }

FigureOptions read_options(const Arguments& args, const ShapeContext& context) {
    FigureOptions out;
    out.facets = facet_settings(args);
    out.smooth = is_curved(out.facets, context.options);
    out.layer = args.is("layer", ValueKind::text) ? args.text("layer") : args.text("layername");
    if (const auto origin = args.numbers("origin", 2)) out.origin = {(*origin)[0], (*origin)[1]};
    out.scale = args.is("scale", ValueKind::number) ? args.number("scale", 1) : 1;
    out.dpi = args.number("dpi", out.dpi);
    out.centre = args.boolean("center", false);
    if (!std::isfinite(out.origin.x) || !std::isfinite(out.origin.y) || !std::isfinite(out.scale))
        args.fail("found an origin or scale that is not finite");
    return out;
}

std::optional<Plane> read_figure(const std::string& name, const FigureOptions& options, const Arguments& args,
                                 ShapeContext& context) {
    const std::string path = path_of(name, context);
    FigureFile drawing;
    try {
        const std::string text = read_bytes(path);
        drawing = lower_extension(name) == ".svg" ? read_svg(text, path, options) : read_dxf(text, path, options);
    } catch (const Error& e) {
        pass_over(e, args, context);
        return std::nullopt;
    }
    for (const std::string& warning : drawing.warnings) context.warnings.add(args.where(), warning);
    std::vector<Plane> parts;
    for (Profile& figure : drawing.figures) parts.push_back({std::move(figure), false, {}});
    if (parts.empty()) {
        context.warnings.add(args.where(), "\"" + name + "\" has nothing to draw: removed");
        return std::nullopt;
    }
    Plane out = parts.size() == 1 ? Plane{contours_of(parts[0], context), true, {}} : unite(parts, context);
    if (out.profile.empty()) return std::nullopt;
    return out;
}

}  // namespace

void pass_over(const Error& error, const Arguments& args, ShapeContext& context) {
    if (error.code() != ErrorCode::io) throw Error(error.code(), args.where() + ": " + error.what());
    context.warnings.add(args.where(), std::string(error.what()) + ": THE PICTURE IS WITHOUT IT");
}

std::string path_of(const std::string& name, const ShapeContext& context) {
    const std::filesystem::path given(name);
    return given.is_absolute() ? name : (std::filesystem::path(context.base_dir) / given).string();
}

std::string lower_extension(const std::string& path) {
    std::string out = std::filesystem::path(path).extension().string();
    for (char& c : out)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return out;
}

bool is_plane_file(const Arguments& args) {
    const std::string type = lower_extension(file_name(args));
    return type == ".dxf" || type == ".svg";
}

std::optional<Plane> plane_file(const Arguments& args, ShapeContext& context) {
    return read_figure(file_name(args), read_options(args, context), args, context);
}

std::optional<Plane> figure_of_extrusion(const Arguments& args, ShapeContext& context) {
    if (!args.is("file", ValueKind::text) || args.text("file").empty()) return std::nullopt;
    return read_figure(args.text("file"), read_options(args, context), args, context);
}

}  // namespace cardioid::formats::openscad
