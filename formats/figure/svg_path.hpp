#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "rt_core/math/vec.hpp"

namespace cardioid::formats {

/// How fine an SVG's curves become lines.
struct SvgFineness {
    int circle = 40;        ///< lines a whole ellipse, as OpenSCAD has it
    int curve = 20;         ///< lines a Bezier curve
    double half_turn = 10;  ///< lines half a turn of an arc, besides four

    static SvgFineness smooth() { return {224, 64, 108}; }
};

struct SvgSubpath {
    std::vector<Vec2d> points;
    bool closed = false;
};

/// The subpaths of a `d` attribute (SVG 1.1, section 8.3), in the element's own units. What cannot be read ends the
/// path, as the standard says.
std::vector<SvgSubpath> parse_svg_path(std::string_view data, const SvgFineness& fineness);

/// An elliptical arc from `from` to `to` (SVG 1.1, appendix F.6.5), appended without its first point.
struct SvgArc {
    Vec2d radii;
    double turn_deg = 0;
    bool large = false, sweep = false;
};
void append_arc(Vec2d from, const SvgArc& arc, Vec2d to, const SvgFineness& fineness, std::vector<Vec2d>& out);

/// Walks through the numbers of an attribute: separated by spaces, commas or nothing but a sign.
class SvgNumbers {
public:
    explicit SvgNumbers(std::string_view text) : rest_(text) {}
    /// False at the end, or where no number stands next.
    bool next(double& out);
    /// A flag of an arc: one digit.
    bool next_flag(bool& out);
    /// The next letter, or 0 where a number or the end comes.
    char letter();
    [[nodiscard]] std::string_view rest() const { return rest_; }

private:
    void skip();
    std::string_view rest_;
};

}  // namespace cardioid::formats
