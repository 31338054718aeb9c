#pragma once
#include <numbers>

#include "rt_core/api/light.hpp"

namespace cardioid::shaders {

/// What lights at infinity share: the sphere around the scene that their photons must pass.
class FarLight : public Light {
public:
    void prepare(Vec3d centre, double radius) override { centre_ = centre, radius_ = radius; }

protected:
    /// Area of the sphere's disc as seen from infinity.
    [[nodiscard]] float disc_area() const noexcept { return static_cast<float>(std::numbers::pi * radius_ * radius_); }
    /// A photon that travels along the unit direction d from a point of that disc, before the sphere.
    [[nodiscard]] LightEmission enter(Vec3 d, Vec2 u_place, Rgb flux) const noexcept {
        const Frame frame(d);
        const Vec2d q = Vec2d(sample_disc(u_place)) * radius_;
        const Vec3d along = normalize(Vec3d(d));
        return {{centre_ + Vec3d(frame.s) * q.x + Vec3d(frame.t) * q.y - along * radius_, along}, flux};
    }

private:
    Vec3d centre_;
    double radius_ = 0;
};

}  // namespace cardioid::shaders
