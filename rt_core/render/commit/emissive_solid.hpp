#pragma once
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "rt_core/api/world.hpp"
#include "rt_core/render/commit/box_lines.hpp"
#include "rt_core/trace/geometry.hpp"

namespace cardioid {

/// A solid or mesh of an emissive material as a light. Directions are drawn among those that meet its box (SeenBox),
/// or, of a ball, evenly within its cone; from inside of either over all directions. What they find on it is left to a
/// ray (LightSample::trace), so any shape, its holes included, lights the scene without bias.
class EmissiveSolid : public Light {
public:
    [[nodiscard]] LightSample sample(Vec3d p, Vec2 u) const noexcept final;
    [[nodiscard]] float pdf(Vec3d p, Vec3 wi) const noexcept final;
    [[nodiscard]] Rgb power() const noexcept final { return power_; }

protected:
    /// is_ball: the solid fills the ball within its box.
    EmissiveSolid(const Box3d& bounds, bool is_ball);

    Vec3d centre_;
    double radius_;  ///< of the bounding sphere; infinite until prepare() for unbounded solids
    Box3d box_;      ///< around it, with room for rounding; empty where the sphere is what directions are drawn from
    Rgb power_;
};

/// An emissive region. Its photons come from uniformly distributed lines through its bounding sphere: a sphere of
/// surface S is crossed by oriented lines of measure pi S, and every place where a line enters the solid stands for
/// flux pi S L of that measure (Cauchy-Crofton; Santalo 1976, chapter 14). So does its power, by lines through its box;
/// where the region knows its area, they only tell the mean radiance.
class EmissiveRegion final : public EmissiveSolid {
public:
    /// most_lines: for the power, at least 512.
    EmissiveRegion(const Region& region, std::uint32_t id, std::span<const Material> materials,
                   std::uint32_t most_lines);
    /// Estimates the power, by more and more lines until its standard error is below 0.05 %; an unbounded region is
    /// taken within the scene's sphere.
    void prepare(Vec3d centre, double radius) override;
    [[nodiscard]] LightEmission emit(Vec2 u_place, Vec2 u_direction) const noexcept override;

private:
    struct Crossing {
        Hit hit;
        Vec3d p;
        Rgb L;
    };
    /// What the lines of one sequence found so far.
    struct LineSums {
        std::array<double, 3> L{};
        double entries = 0;
    };
    /// Calls use(Crossing) at each place where the line enters the solid.
    template <class Use>
    void walk(const Ray& line, Use&& use) const noexcept;
    [[nodiscard]] Ray line(Vec2 u_place, Vec2 u_direction) const noexcept;
    double set_power(std::span<const LineSums> all, double a_line) noexcept;
    /// Lines through the box, or through the bounding sphere where there is no box.
    void add_lines(const std::optional<BoxLines>& box, std::uint32_t sequence, std::uint32_t first, std::uint32_t last,
                   LineSums& sums) const noexcept;

    const Region& region_;
    std::uint32_t id_;
    std::span<const Material> materials_;
    std::uint32_t most_lines_;
};

/// An emissive mesh; its power and photons come from its triangles by area.
class EmissiveMesh final : public EmissiveSolid {
public:
    EmissiveMesh(const TriangleSurface& surface, std::uint32_t id, std::span<const Material> materials);
    [[nodiscard]] LightEmission emit(Vec2 u_place, Vec2 u_direction) const noexcept override;

private:
    using Corners = std::array<Vec3d, 3>;
    [[nodiscard]] Corners corners(std::size_t triangle) const;

    const TriangleSurface& surface_;
    std::uint32_t id_;
    const Material& material_;
    std::vector<double> area_;  ///< cumulative, a triangle each
};

}  // namespace cardioid
