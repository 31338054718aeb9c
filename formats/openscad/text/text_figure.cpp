#include "formats/openscad/text/text_figure.hpp"

#include <algorithm>
#include <cmath>

#include "csg/shapes/profile_offset.hpp"
#include "formats/openscad/text/typeset.hpp"
#include "rt_core/scene/nearest_name.hpp"

namespace cardioid::formats::openscad {
namespace {

std::string word(const Arguments& args, const char* name, const char* fallback) {
    return args.has(name) ? args.text(name) : fallback;
}

/// A word of a list; another is a warning, and then the first of the list.
std::string choice(const Arguments& args, const char* name, std::span<const std::string_view> known,
                   ShapeContext& context) {
    const std::string given = word(args, name, "");
    if (given.empty() || std::ranges::find(known, given) != known.end()) return given;
    context.warnings.add(args.where(), "text() has no " + std::string(name) + " \"" + given.substr(0, 40) + "\"" +
                                           did_you_mean(given, known) + ": ignored");
    return {};
}

/// Lines a curve of a glyph becomes: an eighth of a circle's facets, as a glyph's curves are short.
int curve_segments(double size, const Arguments& args, ShapeContext& context) {
    constexpr int smooth = 12, most = 1000;
    const csg::FacetSettings facets = facet_settings(args);
    const int coarse = std::max(csg::facet_count(size, facets) / 8 + 1, 2);
    return std::min(is_curved(facets, context.options) ? std::max(coarse, smooth) : coarse, most);
}

Typeset read_call(const Arguments& args, ShapeContext& context) {
    static constexpr std::string_view across[] = {"left", "center", "right"};
    static constexpr std::string_view along[] = {"baseline", "top", "center", "bottom"};
    static constexpr std::string_view ways[] = {"ltr", "rtl", "ttb", "btt"};
    Typeset out;
    out.text = word(args, "text", "");
    out.font = word(args, "font", "");
    out.direction = choice(args, "direction", ways, context);
    out.language = word(args, "language", "en");
    out.script = word(args, "script", "");
    out.halign = choice(args, "halign", across, context);
    out.valign = choice(args, "valign", along, context);
    out.size = args.number("size", 10);
    out.spacing = args.number("spacing", 1);
    return out;
}

}  // namespace

std::optional<Plane> text_figure(const Arguments& args, ShapeContext& context) {
    Typeset call = read_call(args, context);
    if (!(call.size > 0) || !std::isfinite(call.size) || !std::isfinite(call.spacing)) {
        context.warnings.add(args.where(), "text() has a size that is not above 0 and finite: removed");
        return std::nullopt;
    }
    call.segments = curve_segments(call.size, args, context);
    const Glyphs glyphs = typeset(call);
    if (!glyphs.missing_font.empty())
        context.warnings.once("font:" + glyphs.missing_font, args.where(),
                              "font \"" + glyphs.missing_font.substr(0, 80) +
                                  "\" is not installed: " + glyphs.used_font + " in its place");
    std::vector<Plane> parts;
    for (const Profile& figure : glyphs.figures)
        if (Profile clean = csg::by_winding(figure, grid_of(call.size, context.options)); !clean.empty())
            parts.push_back({std::move(clean), true, {}});
    if (parts.empty()) return std::nullopt;
    Plane out = unite(parts, context);
    if (out.profile.empty()) return std::nullopt;
    return out;
}

}  // namespace cardioid::formats::openscad
