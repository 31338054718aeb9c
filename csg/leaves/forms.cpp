#include "csg/leaves/forms.hpp"

#include <algorithm>
#include <cmath>

#include "csg/leaves/blobs.hpp"
#include "csg/leaves/polynomial.hpp"
#include "csg/leaves/solvers.hpp"

namespace cardioid::csg {
namespace {

/// Faces 0 to 5 are those of the box, in the order of Solver::box.
constexpr std::uint32_t curved_face = 6;
/// Where a box only bounds the search, its walls stand off by this share, so that they are outside.
constexpr double stand_off = 1e-6;

/// A polynomial of second degree along the line: v(s) = c0 + c1 s + c2 s^2.
using Square = std::array<double, 3>;
/// The product of two that are linear along the line: (a0 + a1 s) (b0 + b1 s).
Square product(double a0, double a1, double b0, double b1) { return {a0 * b0, a0 * b1 + a1 * b0, a1 * b1}; }
Square operator*(double f, const Square& a) { return {f * a[0], f * a[1], f * a[2]}; }
Square operator+(const Square& a, const Square& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Square operator-(const Square& a, const Square& b) { return a + -1.0 * b; }
Polynomial<4> times(const Square& a, const Square& b) {
    return {{a[0] * b[0], a[0] * b[1] + a[1] * b[0], a[0] * b[2] + a[1] * b[1] + a[2] * b[0], a[1] * b[2] + a[2] * b[1],
             a[2] * b[2]}};
}
Polynomial<4> minus(const Polynomial<4>& a, const Polynomial<4>& b) {
    Polynomial<4> out;
    for (std::size_t i = 0; i < 5; ++i) out.c[i] = a.c[i] - b.c[i];
    return out;
}

/// Half the size of an ellipse a x^2 + b x z + c z^2 <= 1 along x and along z.
Vec2d ellipse_reach(double a, double b, double c) {
    const double f = a * c - b * b / 4;
    return {std::sqrt(c / f), std::sqrt(a / f)};
}

/// The polynomial of a bowl, trough or waist along p + s w.
Polynomial<2> second_degree(const Form& form, Vec3d p, Vec3d w) {
    const double k = form.numbers[0], u0 = 1 - p.z, u1 = -w.z;
    Square f = product(p.x, w.x, p.x, w.x);
    if (form.kind != FormKind::trough) f = f + product(p.y, w.y, p.y, w.y);
    f = form.kind == FormKind::waist ? f - (1 - k) * product(p.z, w.z, p.z, w.z) - Square{k, 0, 0}
                                     : f - k * product(u0, u1, u0, u1) - (1 - k) * Square{u0, u1, 0};
    return {f};
}

/// That of a taper or a tilted ring.
Polynomial<4> fourth_degree(const Form& form, Vec3d p, Vec3d w) {
    const auto& n = form.numbers;
    const Square xx = product(p.x, w.x, p.x, w.x), yy = product(p.y, w.y, p.y, w.y);
    if (form.kind == FormKind::taper) {
        const double a0 = 1 + (n[0] - 1) * p.z, a1 = (n[0] - 1) * w.z;
        const double b0 = 1 + (n[1] - 1) * p.z, b1 = (n[1] - 1) * w.z;
        const Square aa = product(a0, a1, a0, a1), bb = product(b0, b1, b0, b1);
        return minus(times(xx, bb), times(yy - bb, -1.0 * aa));
    }
    // With rho^2 = x^2 + y^2 the ellipse is e + rho f <= 0; e^2 = rho^2 f^2 is free of the root.
    const double R = n[0], a = n[1], b = n[2], c = n[3];
    const Square rr = xx + yy, zz = product(p.z, w.z, p.z, w.z), z{p.z, w.z, 0};
    const Square e = a * rr + c * zz - b * R * z + Square{a * R * R - 1, 0, 0};
    const Square f = b * z - Square{2 * a * R, 0, 0};
    return minus(times(e, e), times(rr, product(f[0], f[1], f[0], f[1])));
}

/// The box of the search: as form_box, walls that are no faces a little farther out.
Box3d search_box(const Form& form) {
    Box3d box = form_box(form);
    const bool flat_y = form.kind == FormKind::trough;
    const bool flat_z =
        form.kind != FormKind::tilted_ring && form.kind != FormKind::superellipsoid && form.kind != FormKind::metaball;
    for (int axis = 0; axis < 3; ++axis) {
        if ((axis == 1 && flat_y) || (axis == 2 && flat_z)) continue;
        const double by = stand_off * (box.hi[axis] - box.lo[axis]);
        box.lo[axis] -= by, box.hi[axis] += by;
    }
    return box;
}

/// Events where f changes sign within the span; the line is inside at its ends where f is negative there.
template <int N>
void append_signs(const Polynomial<N>& f, const Span& span, std::uint32_t index, EventList& out) {
    std::array<double, 4> roots;
    const int count = roots_between(f, span.t0, span.t1, roots);
    bool inside = f(span.t0) < 0;
    if (inside) out.push_back(make_event(span.t0, index, span.face0, true));
    for (int i = 0; i < count; ++i) {
        inside = !inside;
        out.push_back(make_event(roots[static_cast<std::size_t>(i)], index, curved_face, inside));
    }
    if (inside) out.push_back(make_event(span.t1, index, span.face1, false));
}

/// A convex function: its least place by golden section, then the two crossings of 1 by bisection.
void append_superellipsoid(const Form& form, Vec3d p, Vec3d w, const Span& span, EventList& out, std::uint32_t index) {
    constexpr double golden = 0.6180339887498949;
    const auto norm = [&](double s) { return superellipsoid_norm(form, p + w * s); };
    double lo = span.t0, hi = span.t1, a = hi - golden * (hi - lo), b = lo + golden * (hi - lo);
    double fa = norm(a), fb = norm(b);
    for (int i = 0; i < 80 && fa >= 1 && fb >= 1; ++i) {
        if (fa < fb) {
            hi = b, b = a, fb = fa, a = hi - golden * (hi - lo), fa = norm(a);
        } else {
            lo = a, a = b, fa = fb, b = lo + golden * (hi - lo), fb = norm(b);
        }
    }
    const double inside = fa < fb ? a : b;
    if (!(norm(inside) < 1)) return;
    const auto crossing = [&](double in, double beyond) {
        for (int i = 0; i < 100; ++i) {
            const double middle = 0.5 * (in + beyond);
            if (middle == in || middle == beyond) break;
            (norm(middle) < 1 ? in : beyond) = middle;
        }
        return in;
    };
    out.push_back(make_event(crossing(inside, span.t0), index, curved_face, true));
    out.push_back(make_event(crossing(inside, span.t1), index, curved_face, false));
}

/// Events where f, outside at both ends of the span, changes sign.
template <class Function>
void append_changes(const Function& f, double t0, double t1, bool& inside, std::uint32_t index, EventList& out) {
    each_sign_change(f, t0, t1, [&](double s) {
        inside = !inside;
        out.push_back(make_event(s, index, curved_face, inside));
    });
}

/// x^power over a range of x >= 0.
Range powers(Range x, double power) {
    const double a = std::pow(x.lo, power), b = std::pow(x.hi, power);
    return power < 0 ? Range{b, a} : Range{a, b};
}

/// A superellipsoid's function along p + s w, where no coordinate changes its sign: each coordinate's size is linear.
class SuperellipsoidLine {
public:
    SuperellipsoidLine(const Form& form, Vec3d p, Vec3d w) : n_(form.numbers[0]), e_(form.numbers[1]), p_(p), w_(w) {}
    [[nodiscard]] double value(double s) const { return sum(abs(p_ + w_ * s)) - 1; }
    [[nodiscard]] Range range(double a, double b) const {
        const Vec3d pa = abs(p_ + w_ * a), pb = abs(p_ + w_ * b);
        return {sum(min(pa, pb)) - 1, sum(max(pa, pb)) - 1};
    }
    [[nodiscard]] Range slope(double a, double b) const {
        const Vec3d pa = abs(p_ + w_ * a), pb = abs(p_ + w_ * b), lo = min(pa, pb), hi = max(pa, pb);
        const Range ring{flat(lo), flat(hi)};
        const Range outer = powers(ring, e_ / n_ - 1);
        Range total{0, 0};
        for (int axis = 0; axis < 3; ++axis) {
            if (w_[axis] == 0) continue;
            const double power = axis < 2 ? 2 / e_ : 2 / n_;
            Range part = powers({lo[axis], hi[axis]}, power - 1);
            if (axis < 2) part = product_of_positive(part, outer);
            const double speed = (pb[axis] - pa[axis]) / (b - a) * (axis < 2 ? 2 / n_ : power);
            total = total + part * speed;
        }
        return std::isnan(total.lo) || std::isnan(total.hi) ? any_range : total;
    }

private:
    [[nodiscard]] double flat(Vec3d q) const { return std::pow(q.x, 2 / e_) + std::pow(q.y, 2 / e_); }
    [[nodiscard]] double sum(Vec3d q) const { return std::pow(flat(q), e_ / n_) + std::pow(q.z, 2 / n_); }
    double n_, e_;
    Vec3d p_, w_;
};

/// One that is not convex: piece by piece between the planes where a coordinate is 0.
void append_hollow(const Form& form, Vec3d p, Vec3d w, const Span& span, EventList& out, std::uint32_t index) {
    std::array<double, 5> ends{span.t0, span.t1, span.t1, span.t1, span.t1};
    for (int axis = 0; axis < 3; ++axis) {
        const double s = -p[axis] / w[axis];
        if (s > span.t0 && s < span.t1) ends[static_cast<std::size_t>(axis) + 1] = s;
    }
    std::sort(ends.begin(), ends.end());
    const SuperellipsoidLine line(form, p, w);
    bool inside = false;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
        if (ends[i] < ends[i + 1]) append_changes(line, ends[i], ends[i + 1], inside, index, out);
}

}  // namespace

Box3d form_box(const Form& form) {
    const auto& n = form.numbers;
    switch (form.kind) {
        case FormKind::bowl:
            return {{-1, -1, 0}, {1, 1, 1}};
        case FormKind::trough:
            return {{-1, 0, 0}, {1, 1, 1}};
        case FormKind::taper: {
            const double x = std::max(1.0, n[0]), y = std::max(1.0, n[1]);
            return {{-x, -y, 0}, {x, y, 1}};
        }
        case FormKind::tilted_ring: {
            const Vec2d reach = ellipse_reach(n[1], n[2], n[3]);
            const double r = n[0] + reach.x;
            return {{-r, -r, -reach.y}, {r, r, reach.y}};
        }
        case FormKind::waist:
        case FormKind::superellipsoid:
        case FormKind::metaball:
            break;
    }
    return {{-1, -1, -1}, {1, 1, 1}};
}

double superellipsoid_norm(const Form& form, Vec3d p) {
    const double n = form.numbers[0], e = form.numbers[1];
    const double xy = std::pow(std::pow(std::abs(p.x), 2 / e) + std::pow(std::abs(p.y), 2 / e), e / n);
    return std::pow(xy + std::pow(std::abs(p.z), 2 / n), n / 2);
}

double form_value(const Form& form, Vec3d p) {
    if (form.kind == FormKind::superellipsoid) return superellipsoid_norm(form, p) - 1;
    if (form.kind == FormKind::metaball) return blob_value(form, p);
    if (form.kind == FormKind::taper || form.kind == FormKind::tilted_ring) return fourth_degree(form, p, {}).c[0];
    return second_degree(form, p, {}).c[0];
}

void append_form(const Form& form, std::uint32_t index, Vec3d o, Vec3d d, EventList& out) {
    const double speed = length(d);
    const Vec3d w = d * (1 / speed);
    const Box3d box = search_box(form);
    // From the place closest to the middle, twice, since a far origin rounds the first.
    double middle = dot(box.centre() - o, w);
    Vec3d p = o + w * middle;
    const double rest = dot(box.centre() - p, w);
    p += w * rest, middle += rest;
    Span span{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    for (int axis = 0; axis < 3; ++axis) {
        const auto face = static_cast<std::uint32_t>(2 * axis);
        clip(span, p[axis], w[axis], box.lo[axis], box.hi[axis], face, face + 1);
    }
    if (span.empty()) return;
    const std::size_t first = out.size();
    bool inside = false;
    if (form.kind == FormKind::metaball)
        append_changes(BlobLine(form, p, w), span.t0, span.t1, inside, index, out);
    else if (form.kind == FormKind::superellipsoid && std::max(form.numbers[0], form.numbers[1]) > 2)
        append_hollow(form, p, w, span, out, index);
    else if (form.kind == FormKind::superellipsoid)
        append_superellipsoid(form, p, w, span, out, index);
    else if (form.kind == FormKind::taper || form.kind == FormKind::tilted_ring)
        append_signs(fourth_degree(form, p, w), span, index, out);
    else
        append_signs(second_degree(form, p, w), span, index, out);
    for (std::size_t i = first; i < out.size(); ++i) out[i].t = (out[i].t + middle) / speed;
}

Vec3d form_normal(const Form& form, std::uint32_t face, Vec3d p) {
    if (face < curved_face) {
        Vec3d n;
        n[static_cast<int>(face / 2)] = face % 2 ? 1 : -1;
        return n;
    }
    const auto& n = form.numbers;
    const double slope = 2 * n[0] * (1 - p.z) + 1 - n[0];
    switch (form.kind) {
        case FormKind::bowl:
            return {2 * p.x, 2 * p.y, slope};
        case FormKind::trough:
            return {2 * p.x, 0, slope};
        case FormKind::waist:
            return {p.x, p.y, (n[0] - 1) * p.z};
        case FormKind::taper: {
            const double a = 1 + (n[0] - 1) * p.z, b = 1 + (n[1] - 1) * p.z;
            return {p.x * b * b, p.y * a * a,
                    b * (n[1] - 1) * (p.x * p.x - a * a) + a * (n[0] - 1) * (p.y * p.y - b * b)};
        }
        case FormKind::tilted_ring: {
            const double rho = std::sqrt(p.x * p.x + p.y * p.y), x = rho - n[0];
            const double radial = rho > 0 ? (2 * n[1] * x + n[2] * p.z) / rho : 0;
            return {p.x * radial, p.y * radial, n[2] * x + 2 * n[3] * p.z};
        }
        case FormKind::metaball:
            return blob_normal(form, p);
        case FormKind::superellipsoid:
            break;
    }
    const double e = n[1], xy = std::pow(std::abs(p.x), 2 / e) + std::pow(std::abs(p.y), 2 / e);
    const double scale = xy > 0 ? std::pow(xy, e / n[0] - 1) : 0;
    // At its ridges, where a power is negative, the normal has no end.
    const auto part = [](double x, double power) {
        return std::copysign(std::pow(std::max(std::abs(x), power < 0 ? 1e-30 : 0.0), power), x);
    };
    return {scale * part(p.x, 2 / e - 1), scale * part(p.y, 2 / e - 1), part(p.z, 2 / n[0] - 1)};
}

}  // namespace cardioid::csg
