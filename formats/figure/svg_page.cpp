#include "formats/figure/svg_page.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "csg/shapes/degrees.hpp"
#include "formats/figure/svg_path.hpp"

namespace cardioid::formats {
namespace {

constexpr double inch = 25.4;

struct Length {
    double number = 0;
    std::string unit;
    bool given = false;
};

Length length_of(const pugi::xml_attribute& attribute) {
    Length out;
    SvgNumbers in(attribute.value());
    out.given = in.next(out.number);
    for (const char c : in.rest())
        if (c != ' ') out.unit += c;
    return out;
}

double to_mm(const Length& length, double view_box, bool has_view_box, double dpi) {
    if (!length.given) return has_view_box ? inch * view_box / dpi : 0;
    const std::string& unit = length.unit;
    if (unit == "%") return has_view_box ? inch * length.number / 100 * view_box / dpi : 0;
    const double mm = unit == "mm"   ? 1
                      : unit == "cm" ? 10
                      : unit == "in" ? inch
                      : unit == "pt" ? inch / 72
                      : unit == "pc" ? inch / 6
                                     : inch / dpi;
    return length.number * mm;
}

double aligned(char where, double page, double drawn) {
    return where == 'a' ? page - drawn : where == 'i' && page != drawn ? (page - drawn) / 2 : 0;
}

/// "Min", "Mid" or "Max" behind x or Y of a preserveAspectRatio.
double alignment(const std::string& ratio, const char* axis, double page, double drawn) {
    const std::size_t at = ratio.find(axis);
    const std::string word = at == std::string::npos ? "Mid" : ratio.substr(at + 1, 3);
    return word == "Min" ? 0 : word == "Max" ? aligned('a', page, drawn) : aligned('i', page, drawn);
}

}  // namespace

SvgPage read_svg_page(const pugi::xml_node& svg, double dpi) {
    SvgPage out;
    std::array<double, 4> box{};
    SvgNumbers numbers(svg.attribute("viewBox").value());
    bool has_box = true;
    for (double& x : box) has_box = has_box && numbers.next(x);
    has_box = has_box && box[2] > 0 && box[3] > 0;
    const Length w = length_of(svg.attribute("width")), h = length_of(svg.attribute("height"));
    const double width = to_mm(w, box[2], has_box, dpi);
    out.height = to_mm(h, box[3], has_box, dpi);
    if (!has_box) {
        out.scale = {inch / dpi, inch / dpi};
        return out;
    }
    const double px = w.unit == "%" ? w.number / 100 : 1, py = h.unit == "%" ? h.number / 100 : 1;
    out.view_box = {px * box[0], py * box[1]};
    out.scale = {px * width / box[2], py * out.height / box[3]};
    const std::string ratio = svg.attribute("preserveAspectRatio").as_string("xMidYMid meet");
    if (ratio.find("none") != std::string::npos) return out;
    const bool slice = ratio.find("slice") != std::string::npos;
    const double scale = slice ? std::max(out.scale.x, out.scale.y) : std::min(out.scale.x, out.scale.y);
    out.scale = {scale, scale};
    out.align = {alignment(ratio, "x", width, scale * box[2]), alignment(ratio, "Y", out.height, scale * box[3])};
    return out;
}

Affine parse_svg_transform(const char* text) {
    Affine out;
    std::string_view rest = text;
    for (std::size_t open = rest.find('('); open != std::string_view::npos; open = rest.find('(')) {
        const std::string_view name = rest.substr(0, open);
        const std::size_t close = std::min(rest.find(')'), rest.size());
        SvgNumbers in(rest.substr(open + 1, close - std::min(close, open + 1)));
        std::array<double, 6> x{};
        std::size_t n = 0;
        while (n < x.size() && in.next(x[n])) ++n;
        const auto is = [&](const char* wanted) { return name.find(wanted) != std::string_view::npos; };
        Affine m;
        if (is("matrix") && n == 6) m = {{Vec3d{x[0], x[2], 0}, {x[1], x[3], 0}, {0, 0, 1}}, {x[4], x[5], 0}};
        if (is("translate")) m = Affine::translation({x[0], x[1], 0});
        if (is("scale")) m = Affine::scaling({x[0], n > 1 ? x[1] : x[0], 1});
        if (is("skewX")) m.row[0].y = std::tan(x[0] * 0.017453292519943295);
        if (is("skewY")) m.row[1].x = std::tan(x[0] * 0.017453292519943295);
        if (is("rotate")) {
            const auto [s, c] = csg::sin_cos_deg(x[0]);
            m = Affine::translation({x[1], x[2], 0}) * Affine{{Vec3d{c, -s, 0}, {s, c, 0}, {0, 0, 1}}, {}} *
                Affine::translation({-x[1], -x[2], 0});
        }
        out = out * m;
        rest.remove_prefix(std::min(close + 1, rest.size()));
    }
    return out;
}

}  // namespace cardioid::formats
