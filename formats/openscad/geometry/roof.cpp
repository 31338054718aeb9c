#include <algorithm>
#include <cmath>

#include "csg/shapes/extrude.hpp"
#include "formats/openscad/geometry/extrusions.hpp"

namespace cardioid::formats::openscad {

Extrusion roof(std::span<const Plane> parts, const Arguments& args, ShapeContext& context) {
    constexpr int fine_cone = 72;  // chords that stay within 1e-3 of the radius
    const std::string method = args.has("method") ? args.text("method") : "voronoi";
    if (method != "voronoi" && method != "straight")
        args.fail("found \"" + method + "\", wanted roof(method = \"voronoi\") or \"straight\"");
    const Profile figure = contours_of(unite(parts, context), context);
    if (figure.empty()) return {};
    double size = 0;
    for (const auto& contour : figure.contours)
        for (const Vec2d p : contour) size = std::max({size, std::abs(p.x), std::abs(p.y)});
    const csg::FacetSettings facets = facet_settings(args);
    const int corners = is_curved(facets, context.options) ? fine_cone : csg::facet_count(size, facets);
    return {make_mesh(csg::roof(figure, method == "voronoi" ? corners : 0), args.where(), context), {}, true};
}

}  // namespace cardioid::formats::openscad
