#pragma once
/// FormKind::metaball: the field of its points.
#include "csg/leaves/crossings.hpp"
#include "rt_core/scene/solid.hpp"

namespace cardioid::csg {

/// The threshold less the field at p: below 0 inside.
double blob_value(const Form& form, Vec3d p);

/// Its gradient: out of the form.
Vec3d blob_normal(const Form& form, Vec3d p);

/// The same function along p + s w, w of length 1, with its bounds over intervals.
class BlobLine {
public:
    BlobLine(const Form& form, Vec3d p, Vec3d w) : form_(form), p_(p), w_(w) {}
    [[nodiscard]] double value(double s) const { return blob_value(form_, p_ + w_ * s); }
    [[nodiscard]] Range range(double a, double b) const;
    [[nodiscard]] Range slope(double a, double b) const;

private:
    const Form& form_;
    Vec3d p_, w_;
};

}  // namespace cardioid::csg
