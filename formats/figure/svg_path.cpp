#include "formats/figure/svg_path.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numbers>

namespace cardioid::formats {
namespace {

class PathParser {
public:
    PathParser(std::string_view data, const SvgFineness& fineness) : in_(data), fineness_(fineness) {}

    std::vector<SvgSubpath> run() {
        char command = 0;
        for (bool good = true; good;) {
            if (const char letter = in_.letter()) {
                command = letter;
                if (command == 'z' || command == 'Z') {
                    close();
                    continue;
                }
            } else if (command == 'm' || command == 'M') {
                command = command == 'm' ? 'l' : 'L';  // further pairs are lines
            }
            good = command != 0 && !in_.rest().empty() && segment(command);
        }
        std::erase_if(out_, [](const SvgSubpath& path) { return path.points.size() < 2; });
        return std::move(out_);
    }

private:
    bool segment(char command) {
        relative_ = std::islower(static_cast<unsigned char>(command)) != 0;
        const char kind = static_cast<char>(std::toupper(static_cast<unsigned char>(command)));
        Vec2d to = at_;
        switch (kind) {
            case 'M':
                if (!pair(to)) return false;
                out_.push_back({{to}, false});
                break;
            case 'L':
                if (!pair(to)) return false;
                line(to);
                break;
            case 'H':
                if (!in_.next(to.x)) return false;
                if (relative_) to.x += at_.x;
                line(to);
                break;
            case 'V':
                if (!in_.next(to.y)) return false;
                if (relative_) to.y += at_.y;
                line(to);
                break;
            case 'A':
                return arc();
            case 'C':
            case 'S':
                return cubic(kind == 'S');
            case 'Q':
            case 'T':
                return quadratic(kind == 'T');
            default:
                return false;
        }
        at_ = control_ = to;
        last_ = kind;
        return true;
    }

    bool pair(Vec2d& out) {
        if (!in_.next(out.x) || !in_.next(out.y)) return false;
        if (relative_) out = out + at_;
        return true;
    }

    std::vector<Vec2d>& points() {
        if (out_.empty() || out_.back().closed) out_.push_back({{at_}, false});
        return out_.back().points;
    }

    void line(Vec2d to) { points().push_back(to); }

    void close() {
        if (out_.empty()) return;
        out_.back().closed = true;
        at_ = control_ = out_.back().points[0];
        last_ = 'Z';
    }

    bool arc() {
        SvgArc arc;
        Vec2d to;
        if (!in_.next(arc.radii.x) || !in_.next(arc.radii.y) || !in_.next(arc.turn_deg) || !in_.next_flag(arc.large) ||
            !in_.next_flag(arc.sweep) || !pair(to))
            return false;
        append_arc(at_, arc, to, fineness_, points());
        at_ = control_ = to;
        last_ = 'A';
        return true;
    }

    /// The control point of a curve that goes on from one of the same kind: the mirror image of its last.
    [[nodiscard]] Vec2d mirrored(char kind, char short_kind) const {
        return last_ == kind || last_ == short_kind ? at_ * 2.0 - control_ : at_;
    }

    bool cubic(bool goes_on) {
        Vec2d b = mirrored('C', 'S'), c, d;
        if ((!goes_on && !pair(b)) || !pair(c) || !pair(d)) return false;
        std::vector<Vec2d>& out = points();
        for (int i = 1; i <= fineness_.curve; ++i) {
            const double t = static_cast<double>(i) / fineness_.curve, s = 1 - t;
            out.push_back(at_ * (s * s * s) + b * (3 * s * s * t) + c * (3 * s * t * t) + d * (t * t * t));
        }
        at_ = d, control_ = c, last_ = 'C';
        return true;
    }

    bool quadratic(bool goes_on) {
        Vec2d b = mirrored('Q', 'T'), d;
        if ((!goes_on && !pair(b)) || !pair(d)) return false;
        std::vector<Vec2d>& out = points();
        for (int i = 1; i <= fineness_.curve; ++i) {
            const double t = static_cast<double>(i) / fineness_.curve, s = 1 - t;
            out.push_back(at_ * (s * s) + b * (2 * s * t) + d * (t * t));
        }
        at_ = d, control_ = b, last_ = 'Q';
        return true;
    }

    SvgNumbers in_;
    SvgFineness fineness_;
    bool relative_ = false;
    Vec2d at_, control_;
    char last_ = 0;
    std::vector<SvgSubpath> out_;
};

}  // namespace

void SvgNumbers::skip() {
    while (!rest_.empty() && (std::isspace(static_cast<unsigned char>(rest_[0])) != 0 || rest_[0] == ','))
        rest_.remove_prefix(1);
}

bool SvgNumbers::next(double& out) {
    skip();
    std::string_view text = rest_;
    if (text.starts_with('+')) text.remove_prefix(1);
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out);
    if (error != std::errc() || !std::isfinite(out)) return false;
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return true;
}

bool SvgNumbers::next_flag(bool& out) {
    skip();
    if (rest_.empty() || (rest_[0] != '0' && rest_[0] != '1')) return false;
    out = rest_[0] == '1';
    rest_.remove_prefix(1);
    return true;
}

char SvgNumbers::letter() {
    skip();
    if (rest_.empty() || std::isalpha(static_cast<unsigned char>(rest_[0])) == 0) return 0;
    const char out = rest_[0];
    rest_.remove_prefix(1);
    return out;
}

void append_arc(Vec2d from, const SvgArc& arc, Vec2d to, const SvgFineness& fineness, std::vector<Vec2d>& out) {
    double rx = std::abs(arc.radii.x), ry = std::abs(arc.radii.y);
    if (rx == 0 || ry == 0 || from == to) return out.push_back(to);
    const double turn = arc.turn_deg * (std::numbers::pi / 180), c = std::cos(turn), s = std::sin(turn);
    const Vec2d half = (from - to) * 0.5, p{c * half.x + s * half.y, -s * half.x + c * half.y};
    const double reach = std::sqrt(p.x * p.x / (rx * rx) + p.y * p.y / (ry * ry));
    if (reach > 1) rx *= reach, ry *= reach;
    const double over = rx * rx * p.y * p.y + ry * ry * p.x * p.x;
    double f = std::sqrt(std::max(0.0, (rx * rx * ry * ry - over) / over));
    if (arc.large == arc.sweep) f = -f;
    const Vec2d q{f * rx * p.y / ry, -f * ry * p.x / rx};
    const Vec2d middle = Vec2d{c * q.x - s * q.y, s * q.x + c * q.y} + (from + to) * 0.5;
    const double begin = std::atan2((p.y - q.y) / ry, (p.x - q.x) / rx);
    double sweep = std::atan2((-p.y - q.y) / ry, (-p.x - q.x) / rx) - begin;
    if (sweep < 0) sweep += 2 * std::numbers::pi;
    if (!arc.sweep) sweep -= 2 * std::numbers::pi;
    if (!std::isfinite(sweep)) return out.push_back(to);  // of radii whose squares are beyond all numbers
    const int steps = static_cast<int>(std::abs(sweep) * fineness.half_turn / std::numbers::pi) + 4;
    for (int i = 1; i < steps; ++i) {
        const double a = begin + sweep * i / steps, x = rx * std::cos(a), y = ry * std::sin(a);
        out.push_back(middle + Vec2d{c * x - s * y, s * x + c * y});
    }
    out.push_back(to);
}

std::vector<SvgSubpath> parse_svg_path(std::string_view data, const SvgFineness& fineness) {
    return PathParser(data, fineness).run();
}

}  // namespace cardioid::formats
