#include "formats/figure/dxf_entity.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>

namespace cardioid::formats {
namespace {

/// A number as OpenSCAD reads it: what is none is 0.
double to_number(std::string_view text) {
    double out = 0;
    if (text.starts_with('+')) text.remove_prefix(1);
    std::from_chars(text.data(), text.data() + text.size(), out);
    return std::isfinite(out) ? out : 0;
}

/// What an arc from one angle to another runs through, once around at most; damaged drawings have any angle.
double sweep_of(double from, double to, double whole) {
    const double sweep = from > to ? to - from + whole * std::ceil((from - to) / whole) : to - from;
    return sweep >= 0 && sweep <= whole ? sweep : std::isfinite(sweep) ? std::fmod(std::abs(sweep), whole) : whole;
}

/// The lines of a curve p(0) ... p(1).
template <class Curve>
void trace(int steps, Curve&& p, std::vector<Line>& out) {
    Vec2d last = p(0.0);
    for (int i = 1; i <= steps; ++i) {
        const Vec2d next = p(static_cast<double>(i) / steps);
        out.push_back({last, next});
        last = next;
    }
}

}  // namespace

int arc_steps(double r, double sweep, const FigureOptions& options) {
    constexpr double smooth = 224;  // corners of a circle: 1e-4 of its radius
    const double whole = options.smooth ? smooth : csg::facet_count(r, options.facets);
    return std::max(1, static_cast<int>(std::ceil(whole * std::abs(sweep) / (2 * std::numbers::pi) - 1e-9)));
}

void DxfEntity::set(std::int64_t code, std::string_view value) {
    if (code == 2) name = value;
    if (code == 8) layer = value;
    if (code == 10 || code == 11) xs_.push_back(to_number(value));
    if (code == 20 || code == 21) ys_.push_back(to_number(value));
    if (code == 40 || code == 41 || code == 42 || code == 50 || code == 51 || code == 70)
        numbers_.emplace_back(static_cast<int>(code), to_number(value));
}

double DxfEntity::number(int code, double fallback) const {
    const auto at = std::find_if(numbers_.rbegin(), numbers_.rend(), [&](const auto& n) { return n.first == code; });
    return at == numbers_.rend() ? fallback : at->second;
}

Vec2d DxfEntity::point(std::size_t i, const FigureOptions& options, bool top_level) const {
    if (i >= xs_.size() || i >= ys_.size()) return {};
    const Vec2d p{xs_[i], ys_[i]};
    return top_level ? (p - options.origin) * options.scale : p;
}

bool DxfEntity::draw(const FigureOptions& options, bool top_level, std::vector<Line>& out) const {
    if (type == "LINE") {
        if (xs_.size() >= 2 && ys_.size() >= 2)
            out.push_back({point(0, options, top_level), point(1, options, top_level)});
    } else if (type == "LWPOLYLINE") {
        polyline(options, top_level, out);
    } else if (type == "CIRCLE") {
        arc(0, 360, options, top_level, out);
    } else if (type == "ARC") {
        arc(number(50, 0), number(51, 0), options, top_level, out);
    } else if (type == "ELLIPSE") {
        ellipse(options, top_level, out);
    } else {
        return false;
    }
    return true;
}

void DxfEntity::polyline(const FigureOptions& options, bool top_level, std::vector<Line>& out) const {
    const std::size_t n = std::min(xs_.size(), ys_.size());
    for (std::size_t i = 1; i < n; ++i) out.push_back({point(i - 1, options, top_level), point(i, options, top_level)});
    const bool closed = std::fmod(std::abs(number(70, 0)), 2) >= 1;
    if (closed && n > 1) out.push_back({point(n - 1, options, top_level), point(0, options, top_level)});
}

void DxfEntity::arc(double from_deg, double to_deg, const FigureOptions& options, bool top_level,
                    std::vector<Line>& out) const {
    const Vec2d centre = point(0, options, top_level);
    const double r = number(40, 0) * (top_level ? options.scale : 1);
    const double from = from_deg * (std::numbers::pi / 180);
    const double sweep = sweep_of(from_deg, to_deg, 360) * (std::numbers::pi / 180);
    trace(
        arc_steps(r, sweep, options),
        [&](double t) {
            return centre + Vec2d{std::cos(from + t * sweep), std::sin(from + t * sweep)} * r;
        },
        out);
}

/// Group 11 is the greater half axis as seen from the centre, 40 the share of the lesser.
void DxfEntity::ellipse(const FigureOptions& options, bool top_level, std::vector<Line>& out) const {
    if (xs_.size() < 2 || ys_.size() < 2) return;
    const Vec2d centre = point(0, options, top_level);
    const Vec2d major = Vec2d{xs_[1], ys_[1]} * (top_level ? options.scale : 1);
    const Vec2d minor = Vec2d{-major.y, major.x} * number(40, 1);
    const double from = number(41, 0);
    const double sweep = sweep_of(from, number(42, 2 * std::numbers::pi), 2 * std::numbers::pi);
    trace(
        arc_steps(length(major), sweep, options),
        [&](double t) {
            const double a = from + t * sweep;
            return centre + major * std::cos(a) + minor * std::sin(a);
        },
        out);
}

}  // namespace cardioid::formats
