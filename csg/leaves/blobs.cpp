#include "csg/leaves/blobs.hpp"

#include <algorithm>
#include <cmath>

namespace cardioid::csg {

namespace {

enum class Method { nishimura, inverse_square, gaussian };

Method method_of(const Form& form) { return static_cast<Method>(static_cast<int>(form.numbers[0])); }

/// The field of a point with strength above 0 by the square of the distance; it only falls.
double field(Method method, const Blob& blob, double square) {
    const double strength = std::abs(blob.strength), share = square / (strength * strength);
    switch (method) {
        case Method::inverse_square:
            return 1 / share;
        case Method::gaussian:
            return std::exp(blob.sharpness * (1 - share));
        case Method::nishimura:
            break;
    }
    if (share >= 1) return 0;
    if (share <= 1.0 / 9) return 1 - 3 * share;
    const double rest = 1 - std::sqrt(share);
    return 1.5 * rest * rest;
}

/// Its slope by the square of the distance, turned positive; that only falls, too.
double fall(Method method, const Blob& blob, double square) {
    const double s2 = blob.strength * blob.strength, share = square / s2;
    switch (method) {
        case Method::inverse_square:
            return 1 / (share * share * s2);
        case Method::gaussian:
            return blob.sharpness / s2 * std::exp(blob.sharpness * (1 - share));
        case Method::nishimura:
            break;
    }
    if (share >= 1) return 0;
    return (share <= 1.0 / 9 ? 3 : 1.5 * (1 / std::sqrt(share) - 1)) / s2;
}

double sign(const Blob& blob) { return blob.strength < 0 ? -1 : 1; }

/// The line's place closest to a point, and the square of the distance there.
struct Closest {
    double s, square;
};
Closest closest(const Blob& blob, Vec3d p, Vec3d w) {
    const Vec3d to = blob.centre - p;
    const double s = dot(to, w);
    const Vec3d aside = to - w * s;
    return {s, dot(aside, aside)};
}

/// Squares of the distance over an interval.
Range squares(Closest c, double a, double b) {
    const double da = (a - c.s) * (a - c.s), db = (b - c.s) * (b - c.s);
    return {c.square + (c.s > a && c.s < b ? 0 : std::min(da, db)), c.square + std::max(da, db)};
}

}  // namespace

double blob_value(const Form& form, Vec3d p) {
    const Method method = method_of(form);
    double sum = 0;
    for (const Blob& blob : *form.blobs) sum += sign(blob) * field(method, blob, dot(p - blob.centre, p - blob.centre));
    return form.numbers[1] - sum;
}

Vec3d blob_normal(const Form& form, Vec3d p) {
    const Method method = method_of(form);
    Vec3d n;
    for (const Blob& blob : *form.blobs) {
        const Vec3d away = p - blob.centre;
        n += away * (sign(blob) * fall(method, blob, dot(away, away)));
    }
    return n;
}

Range BlobLine::range(double a, double b) const {
    const Method method = method_of(form_);
    Range sum{form_.numbers[1], form_.numbers[1]};
    for (const Blob& blob : *form_.blobs) {
        const Range q = squares(closest(blob, p_, w_), a, b);
        sum = sum + Range{field(method, blob, q.hi), field(method, blob, q.lo)} * -sign(blob);
    }
    return sum;
}

Range BlobLine::slope(double a, double b) const {
    const Method method = method_of(form_);
    Range sum{0, 0};
    for (const Blob& blob : *form_.blobs) {
        const Closest c = closest(blob, p_, w_);
        const Range q = squares(c, a, b), falls{fall(method, blob, q.hi), fall(method, blob, q.lo)};
        // The value rises by twice the way from the closest place, times the fall.
        const double da = 2 * (a - c.s), db = 2 * (b - c.s);
        const Range rise{da * (da < 0 ? falls.hi : falls.lo), db * (db < 0 ? falls.lo : falls.hi)};
        if (std::isnan(rise.lo) || std::isnan(rise.hi)) return any_range;
        sum = sum + rise * sign(blob);
    }
    return sum;
}

}  // namespace cardioid::csg
