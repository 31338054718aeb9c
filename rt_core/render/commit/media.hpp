#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "rt_core/api/world.hpp"
#include "rt_core/trace/tracer.hpp"

namespace cardioid {

/// What the two sides of a surface are filled with; never null.
struct Interface {
    const Medium* front;  ///< towards +ng
    const Medium* back;
};

/// Tells what fills a place where transparent solids may overlap: the medium of the highest priority, at equal
/// priority the one of the earlier solid (Schmidt, Budge 2002, "Simple Nested Dielectrics in Ray Traced Images").
/// It asks every transparent solid whose box holds the place, so there is no stack that could go wrong.
class Media {
public:
    Media(const Tracer& tracer, std::span<const Material> materials);

    [[nodiscard]] const Medium* at(Vec3d p) const noexcept;
    /// Around the point p of the surface that `hit` found.
    [[nodiscard]] Interface around(Vec3d p, const Hit& hit) const noexcept {
        return all_vacuum_ ? Interface{&vacuum, &vacuum} : resolve(p, hit);
    }
    /// Whether the surface at p bounds nothing that light could see: the medium is the same on both sides.
    [[nodiscard]] bool hides(Vec3d p, const Hit& hit) const noexcept;
    /// False where no surface can be hidden, so that hides() need not be asked.
    [[nodiscard]] bool overlap() const noexcept { return overlap_; }

private:
    struct Solid {
        const Region* region;
        std::uint32_t id;
        Box3d bounds;
    };
    static constexpr Medium vacuum{};
    [[nodiscard]] static const Medium* or_vacuum(const Medium* m) noexcept { return m ? m : &vacuum; }
    [[nodiscard]] Interface resolve(Vec3d p, const Hit& hit) const noexcept;
    [[nodiscard]] const Medium* interior(const Solid& solid, Vec3d p) const noexcept;

    const Tracer& tracer_;
    std::span<const Material> materials_;
    std::vector<Solid> solids_;  ///< those with a transparent material, in file order
    bool overlap_ = false;
    bool all_vacuum_ = false;  ///< no material lets light in
};

}  // namespace cardioid
