#pragma once
#include <limits>
#include <span>

#include "csg/region/solid_region.hpp"

namespace cardioid::csg {

/// Walks one ray through one region: next() gives its boundaries one by one, and no leaf is solved before its box is
/// reached. Uses buffers of the thread, so only one sweep may live on a thread at a time.
class Sweep {
public:
    /// Reads ray.from_ng where ray.from names a face: faces parallel to it through the origin are passed over.
    Sweep(const SolidRegion& region, const Ray& ray);
    Sweep(const Sweep&) = delete;
    Sweep& operator=(const Sweep&) = delete;

    /// Whether just before, and just after, the origin the ray is inside.
    [[nodiscard]] bool inside_before() const noexcept { return inside_before_; }
    [[nodiscard]] bool inside_after() const noexcept { return inside_after_; }
    /// The next boundary below ray.t_max; false where there is none.
    bool next(Boundary& out) noexcept;

private:
    struct Buffers;
    static Buffers& buffers() noexcept;

    void solve_all() noexcept;
    void solve(std::uint32_t input) noexcept;
    void take(double t, std::uint32_t input, std::uint32_t face, bool entering) noexcept;
    void visit() noexcept;
    void visit_until(double t) noexcept;
    void start() noexcept;
    void flip(const Event& event) noexcept;
    void flip_all(std::span<const Event> events) noexcept;
    void take_tied() noexcept;
    [[nodiscard]] bool inside() const noexcept;
    [[nodiscard]] Vec3d normal_of(const Event& event) const noexcept;
    [[nodiscard]] const Event& owner() const noexcept;
    bool cancelled(const Event& opener, const Vec3d& n) noexcept;

    const SolidRegion& region_;
    const Ray& ray_;
    Buffers& buffers_;
    BoxRay box_ray_;
    float node_end_ = 0;  ///< beyond it no node matters, counted from entry_t_
    double entry_t_ = 0;  ///< where the ray enters the region's box; distances in the hierarchy count from there
    double end_;          ///< boundaries from here on are not wanted
    double exact_ = 0;    ///< events closer than this tie
    double now_ = -std::numeric_limits<double>::infinity();  ///< how far the sweep has come
    bool inside_before_ = false, inside_after_ = false;
};

}  // namespace cardioid::csg
