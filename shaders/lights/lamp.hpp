#pragma once
#include <vector>

#include "rt_core/api/light.hpp"

namespace cardioid::shaders {

/// What lamps with a surface share: Lambertian radiance from it, power = pi radiance area, its plate or ball.
class Lamp : public Light {
public:
    [[nodiscard]] Rgb power() const noexcept override;
    [[nodiscard]] std::optional<LampShape> shape() const noexcept override;
    void set_face(FaceId face) override { face_ = face; }
    [[nodiscard]] int grid() const noexcept override { return grid_; }

protected:
    /// Reads `radiance` (1) or `power`, `visible` (true) and `grid` (0). area: of the emitting side, scene units^2.
    Lamp(const Params& params, const LampShape& shape, double area);

    /// A photon from o with Lambert's distribution about the emitting side's unit normal.
    [[nodiscard]] LightEmission leave(Vec3d o, Vec3d normal, Vec2 u_direction) const noexcept;
    /// A photon from o along the unit direction d, on the side of the unit normal.
    [[nodiscard]] LightEmission leave_along(Vec3d o, Vec3d normal, Vec3 d) const noexcept;
    [[nodiscard]] Rgb radiance() const noexcept { return radiance_; }
    [[nodiscard]] double area() const noexcept { return area_; }
    /// A point of a grid, and the unit normal of the lamp there.
    struct GridPoint {
        Vec3d q, n;
    };
    /// Takes the next point of the grid, row by row.
    void add_grid_point(const GridPoint& point) { grid_points_.push_back(point); }
    /// With a grid: the light at p of the point of the stratum that u lies in, when it shines for the whole lamp.
    [[nodiscard]] LightSample sample_grid(Vec3d p, Vec2 u) const noexcept;

private:
    LampShape shape_;
    double area_;
    Rgb radiance_;
    bool visible_;
    int grid_;
    FaceId face_;
    std::vector<GridPoint> grid_points_;  ///< row by row
};

/// A flat lamp: where it lies and which way it shines.
struct Plate {
    Vec3d centre, x, y;  ///< images of the local unit vectors x and y
    Vec3d front;         ///< unit normal of the emitting side, the image of local -z
    /// Throws Error(bad_input) where the transform flattens the plate.
    Plate(const Affine& to_world, const Params& params);

    /// A point of the plate towards which a direction leads from p.
    struct Aim {
        double distance = 0;  ///< 0: p is not in front, or the direction does not meet the plane
        double cosine = 0;    ///< at the lamp
        Vec3d q;              ///< from the centre to the point met
    };
    [[nodiscard]] Aim aim(Vec3d p, Vec3d wi) const noexcept;
};

/// A density [1/sr] as float; 0 where it is too large for one, as from lamps that are too far away to matter.
float finite_density(double pdf) noexcept;

/// What sampling the point q of a plate by density 1/area means as a direction from p; black from behind.
LightSample sample_plate_point(const Plate& plate, double area, Rgb radiance, Vec3d p, Vec3d q) noexcept;

/// By how much to_world scales lengths along its first `axes` (2 or 3) axes. Throws Error(bad_input) where it does not
/// scale them alike and keep them at right angles.
double similarity_scale(const Affine& to_world, const Params& params, int axes);

/// Reads `grid`: 0, or K for K x K points instead of the whole lamp. Throws Error(bad_input).
int read_grid(const Params& params);
/// Number of the stratum that u lies in, of grid x grid, row by row.
std::size_t grid_number(Vec2 u, int grid) noexcept;
/// Calls use(u) with the middle of each stratum of grid x grid, row by row.
template <class Use>
void each_stratum(int grid, Use&& use) {
    const auto side = static_cast<float>(grid);
    for (int y = 0; y < grid; ++y)
        for (int x = 0; x < grid; ++x)
            use(Vec2{(static_cast<float>(x) + 0.5F) / side, (static_cast<float>(y) + 0.5F) / side});
}

/// A length above 0 that must be given. Throws Error(bad_input).
double required_length(const Params& params, const char* name);

}  // namespace cardioid::shaders
