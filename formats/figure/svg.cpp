#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <pugixml.hpp>

#include "csg/shapes/profile_offset.hpp"
#include "formats/figure/figure_file.hpp"
#include "formats/figure/svg_page.hpp"
#include "formats/figure/svg_path.hpp"
#include "formats/mesh/text_cursor.hpp"
#include "formats/mesh/xml_mesh.hpp"
#include "rt_core/api/error.hpp"

namespace cardioid::formats {
namespace {

double number(const pugi::xml_node& node, const char* name, double fallback = 0) {
    double out = fallback;
    SvgNumbers(node.attribute(name).value()).next(out);
    return out;
}

/// A property given as an attribute or within `style`.
std::string property(const pugi::xml_node& node, const std::string& name) {
    if (const pugi::xml_attribute given = node.attribute(name.c_str())) return given.value();
    const std::string style = node.attribute("style").value();
    for (std::size_t at = 0; at < style.size();) {
        const std::size_t end = std::min(style.find(';', at), style.size()), colon = style.find(':', at);
        std::string key = style.substr(at, std::min(colon, end) - at);
        std::erase(key, ' ');
        if (key == name && colon < end) return style.substr(colon + 1, end - colon - 1);
        at = end + 1;
    }
    return {};
}

/// Draws the elements as OpenSCAD 2021.01 does: closed paths are filled, open ones are as wide as their stroke.
class SvgReader {
public:
    SvgReader(const std::string& file, const FigureOptions& options)
        : file_(file), options_(options), fineness_(options.smooth ? SvgFineness::smooth() : SvgFineness{}) {}

    FigureFile read(const pugi::xml_node& svg) {
        page_ = read_svg_page(svg, options_.dpi);
        children(svg, parse_svg_transform(svg.attribute("transform").value()), 0);
        place();
        for (const auto& [name, count] : unknown_)
            out_.warnings.push_back(file_ + ": " + std::to_string(count) + " elements " + quoted(name) +
                                    " are left out");
        return std::move(out_);
    }

private:
    void children(const pugi::xml_node& parent, const Affine& map, int depth) {
        constexpr int deepest = 1000;
        if (depth > deepest) throw Error(ErrorCode::bad_input, file_ + ": found elements nested deeper than 1000");
        for (const pugi::xml_node& node : parent.children())
            if (node.type() == pugi::node_element) element(node, map, depth);
    }

    void element(const pugi::xml_node& node, const Affine& outer, int depth) {
        static constexpr std::string_view silent[] = {"defs",     "metadata",           "title",         "desc",
                                                      "style",    "sodipodi:namedview", "marker",        "symbol",
                                                      "clipPath", "linearGradient",     "radialGradient"};
        std::string name = node.name();
        if (name.starts_with("svg:")) name.erase(0, 4);
        const Affine map = outer * parse_svg_transform(node.attribute("transform").value());
        if (name == "g" || name == "a" || name == "svg") return children(node, map, depth + 1);
        if (std::ranges::find(silent, name) != std::end(silent)) return;
        if (name == "use") return use(node, map, depth);
        std::vector<SvgSubpath> paths = draw(name, node);
        if (paths.empty()) {
            if (!is_shape(name)) ++unknown_[name];
            return;
        }
        add(paths, node, map);
    }

    static bool is_shape(const std::string& name) {
        static constexpr std::string_view known[] = {"path", "rect",    "circle",  "ellipse",
                                                     "line", "polygon", "polyline"};
        return std::ranges::find(known, name) != std::end(known);
    }

    /// Another element by its id, moved.
    void use(const pugi::xml_node& node, const Affine& map, int depth) {
        std::string id = node.attribute("href") ? node.attribute("href").value() : node.attribute("xlink:href").value();
        if (!id.starts_with('#')) return;
        id.erase(0, 1);
        const pugi::xml_node target =
            node.root().find_node([&](const pugi::xml_node& n) { return id == n.attribute("id").value(); });
        constexpr int deepest = 100;  // an element may use itself
        if (!target || depth > deepest) return;
        constexpr int most_uses = 100'000;  // each may be of two more
        if (++uses_ > most_uses)
            throw Error(ErrorCode::limit,
                        file_ + ": found more than " + std::to_string(most_uses) + " uses of elements");
        element(target, map * Affine::translation({number(node, "x"), number(node, "y"), 0}), depth + 1);
    }

    [[nodiscard]] std::vector<SvgSubpath> draw(const std::string& name, const pugi::xml_node& node) const {
        if (name == "path") return parse_svg_path(node.attribute("d").value(), fineness_);
        if (name == "rect") return rectangle(node);
        if (name == "circle" || name == "ellipse") return ellipse(node, name == "circle");
        SvgSubpath out;
        if (name == "line") {
            out.points = {{number(node, "x1"), number(node, "y1")}, {number(node, "x2"), number(node, "y2")}};
        } else if (name == "polygon" || name == "polyline") {
            SvgNumbers in(node.attribute("points").value());
            for (Vec2d p; in.next(p.x) && in.next(p.y);) out.points.push_back(p);
            out.closed = name == "polygon";
        }
        if (out.points.size() < 2) return {};
        return {out};
    }

    [[nodiscard]] std::vector<SvgSubpath> ellipse(const pugi::xml_node& node, bool circle) const {
        const Vec2d c{number(node, "cx"), number(node, "cy")};
        const Vec2d r{number(node, circle ? "r" : "rx"), number(node, circle ? "r" : "ry")};
        if (!(r.x > 0 && r.y > 0)) return {};
        SvgSubpath out{{}, true};
        for (int i = 0; i < fineness_.circle; ++i) {
            const auto [s, co] = csg_turn(i);
            out.points.push_back({c.x + r.x * s, c.y + r.y * co});
        }
        return {out};
    }

    [[nodiscard]] std::pair<double, double> csg_turn(int i) const {
        const double a = 2 * std::numbers::pi * i / fineness_.circle;
        return {std::sin(a), std::cos(a)};
    }

    [[nodiscard]] std::vector<SvgSubpath> rectangle(const pugi::xml_node& node) const {
        const double x = number(node, "x"), y = number(node, "y"), w = number(node, "width"),
                     h = number(node, "height");
        if (!(w > 0 && h > 0)) return {};
        double rx = number(node, "rx"), ry = number(node, "ry");
        if (!node.attribute("rx")) rx = ry;
        if (!node.attribute("ry")) ry = rx;
        rx = std::min(rx, w / 2), ry = std::min(ry, h / 2);
        if (!(rx > 0 && ry > 0)) return {{{{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}}, true}};
        const SvgArc arc{{rx, ry}, 0, false, true};
        SvgSubpath out{{{x + rx, y}, {x + w - rx, y}}, true};
        std::vector<Vec2d>& p = out.points;
        append_arc(p.back(), arc, {x + w, y + ry}, fineness_, p);
        p.push_back({x + w, y + h - ry});
        append_arc(p.back(), arc, {x + w - rx, y + h}, fineness_, p);
        p.push_back({x + rx, y + h});
        append_arc(p.back(), arc, {x, y + h - ry}, fineness_, p);
        p.push_back({x, y + ry});
        append_arc(p.back(), arc, {x + rx, y}, fineness_, p);
        return {out};
    }

    /// The closed paths of an element are one figure, each open one is another.
    void add(const std::vector<SvgSubpath>& paths, const pugi::xml_node& node, const Affine& map) {
        Profile filled;
        for (const SvgSubpath& path : paths) {
            constexpr double meet = 0.1;  // ends this near make a closed path
            const bool closed = path.closed || length(path.points.front() - path.points.back()) <= meet;
            if (closed) {
                filled.contours.push_back(path.points);
                continue;
            }
            Profile line = csg::widened_line(path.points, stroke_width(node), line_end(node));
            if (!line.empty()) add_figure(std::move(line), map);
        }
        if (!filled.empty()) add_figure(std::move(filled), map);
    }

    static double stroke_width(const pugi::xml_node& node) {
        double width = 0;
        SvgNumbers(property(node, "stroke-width")).next(width);
        return width < 0.01 ? 1 : width;
    }

    static csg::LineEnd line_end(const pugi::xml_node& node) {
        std::string cap = property(node, "stroke-linecap");
        std::erase(cap, ' ');
        return cap == "butt" ? csg::LineEnd::butt : cap == "round" ? csg::LineEnd::round : csg::LineEnd::square;
    }

    void add_figure(Profile figure, const Affine& map) {
        for (auto& contour : figure.contours)
            for (Vec2d& p : contour) {
                const Vec3d q = map.point({p.x, p.y, 0});
                if (!is_finite(q))
                    throw Error(ErrorCode::bad_input, file_ + ": found a point that is beyond all numbers");
                p = {q.x, q.y};
            }
        out_.figures.push_back(std::move(figure));
    }

    /// From the drawing's units, y down, to millimetres, y up.
    void place() {
        Vec2d middle{-page_.align.x, page_.height - page_.align.y}, corner = page_.view_box;
        if (options_.centre) {
            Box3d box;
            for (const Profile& figure : out_.figures)
                for (const auto& contour : figure.contours)
                    for (const Vec2d p : contour) box.include(Vec3d{page_.scale.x * p.x, page_.scale.y * p.y, 0});
            if (!box.empty()) middle = {box.centre().x, box.centre().y};
        }
        for (Profile& figure : out_.figures)
            for (auto& contour : figure.contours)
                for (Vec2d& p : contour)
                    p = {page_.scale.x * (p.x - corner.x) - middle.x, page_.scale.y * (corner.y - p.y) + middle.y};
    }

    const std::string& file_;
    const FigureOptions& options_;
    SvgFineness fineness_;
    SvgPage page_;
    FigureFile out_;
    std::map<std::string, int> unknown_;
    int uses_ = 0;
};

}  // namespace

FigureFile read_svg(std::string_view text, const std::string& file, const FigureOptions& options) {
    pugi::xml_document document;
    parse_xml(text, file, document);
    pugi::xml_node svg = document.child("svg");
    if (!svg) svg = document.child("svg:svg");
    if (!svg) throw Error(ErrorCode::bad_input, file + ":1: found no <svg>, wanted an SVG");
    return SvgReader(file, options).read(svg);
}

}  // namespace cardioid::formats
