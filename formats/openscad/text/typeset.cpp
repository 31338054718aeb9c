#include "formats/openscad/text/typeset.hpp"

#include <algorithm>
#include <harfbuzz/hb-ft.h>

#include "formats/openscad/text/font.hpp"
#include "formats/openscad/text/outline.hpp"
#include "rt_core/api/error.hpp"

namespace cardioid::formats::openscad {
namespace {

struct DestroyFont {
    void operator()(hb_font_t* font) const { hb_font_destroy(font); }
};
struct DestroyBuffer {
    void operator()(hb_buffer_t* buffer) const { hb_buffer_destroy(buffer); }
};
using Buffer = std::unique_ptr<hb_buffer_t, DestroyBuffer>;

/// OpenSCAD divides advances and alignments, not outlines, by 1024 where it multiplied by 1000.
constexpr double advance_units = font_units * 1.024;

Buffer shape(const Typeset& what, FT_Face face) {
    const std::unique_ptr<hb_font_t, DestroyFont> font(hb_ft_font_create(face, nullptr));
    Buffer buffer(hb_buffer_create());
    const auto length = static_cast<int>(what.text.size());
    hb_buffer_add_utf8(buffer.get(), what.text.c_str(), length, 0, length);
    const hb_direction_t direction = hb_direction_from_string(what.direction.c_str(), -1);
    if (direction != HB_DIRECTION_INVALID) hb_buffer_set_direction(buffer.get(), direction);
    const hb_script_t script = hb_script_from_string(what.script.c_str(), -1);
    if (script != HB_SCRIPT_INVALID) hb_buffer_set_script(buffer.get(), script);
    if (!what.language.empty())
        hb_buffer_set_language(buffer.get(), hb_language_from_string(what.language.c_str(), -1));
    hb_buffer_guess_segment_properties(buffer.get());  // what is not said
    hb_shape(font.get(), buffer.get(), nullptr, 0);
    return buffer;
}

/// A shaped text: per glyph its outline in units of size 1, and how far the next is.
struct Line {
    struct Glyph {
        Outline outline;
        Vec2d offset, advance;
    };
    std::vector<Glyph> glyphs;
    bool horizontal = true;
};

Line set_line(const Typeset& what, const Font& font) {
    const Buffer buffer = shape(what, font.face());
    Line out;
    out.horizontal = HB_DIRECTION_IS_HORIZONTAL(hb_buffer_get_direction(buffer.get()));
    unsigned count = 0;
    const hb_glyph_info_t* const infos = hb_buffer_get_glyph_infos(buffer.get(), &count);
    const hb_glyph_position_t* const places = hb_buffer_get_glyph_positions(buffer.get(), &count);
    for (unsigned i = 0; i < count; ++i) {
        const auto unit = [](hb_position_t x) { return x / advance_units; };
        const hb_glyph_position_t& at = places[i];
        out.glyphs.push_back({draw_glyph(font.face(), infos[i].codepoint, what.segments),
                              {unit(at.x_offset), unit(at.y_offset)},
                              Vec2d{unit(at.x_advance), unit(at.y_advance)} * what.spacing});
    }
    return out;
}

Vec2d alignment(const Line& line, const Typeset& what) {
    double width = 0, ascent = 0, descent = 0;
    for (const auto& glyph : line.glyphs) {
        const Outline& o = glyph.outline;
        if (line.horizontal) {
            width += glyph.advance.x;
            ascent = std::max(ascent, o.top / advance_units);
            descent = std::max(descent, -o.bottom / advance_units);
        } else {
            width = std::max(width, (o.right - o.left) / advance_units);
            ascent += glyph.advance.y;
        }
    }
    Vec2d out;
    if (what.halign == "right") out.x = -width;
    if (what.halign == "center") out.x = -width / 2;
    if (what.valign == "top") out.y = -ascent;
    if (what.valign == "center") out.y = descent / 2 - ascent / 2;
    if (what.valign == "bottom") out.y = descent;
    return out;
}

}  // namespace

Glyphs typeset(const Typeset& what) {
    const Font font(what.font);
    Glyphs out;
    if (!font.is_as_asked()) out.missing_font = what.font, out.used_font = font.family();
    const Line line = set_line(what, font);
    Vec2d pen = alignment(line, what);
    for (const auto& glyph : line.glyphs) {
        Profile figure = glyph.outline.figure;
        for (auto& contour : figure.contours)
            for (Vec2d& p : contour) p = (p + pen + glyph.offset) * what.size;
        if (!figure.empty()) out.figures.push_back(std::move(figure));
        pen = pen + glyph.advance;
    }
    return out;
}

}  // namespace cardioid::formats::openscad
