#pragma once
#include <vector>

#include "rt_core/api/world.hpp"

namespace cardioid {

/// Chooses one light for a point, those that are bright or near more often. Lights with a place stand in a binary tree
/// whose nodes know their flux and their box; a choice walks down from the root (as Conty Estevez, Kulla 2018, but by
/// flux over squared distance alone). Lights at infinity stand beside it. Read-only once made.
class LightChoice {
public:
    /// The world's lights must be prepared.
    explicit LightChoice(const World& world);

    struct Choice {
        std::size_t light = 0;
        float chance = 0;  ///< 0: there is no light that gives any
    };
    /// One light for the point p; u in [0, 1).
    [[nodiscard]] Choice choose(Vec3d p, float u) const noexcept;
    /// With which chance choose() draws that light; 0 for a light whose power is nothing.
    [[nodiscard]] float chance(Vec3d p, std::size_t light) const noexcept;
    /// Whether the number that choose() takes matters.
    [[nodiscard]] bool several() const noexcept { return lights_ > 1; }

private:
    struct Node {
        Vec3d centre;
        double radius2 = 0;  ///< of the ball around what is below
        double flux = 0;
        std::uint32_t parent = 0;
        std::uint32_t left = 0;  ///< the right child follows it; 0 for a leaf
        std::uint32_t light = 0;
    };
    struct Placed {
        std::uint32_t light;
        Box3d box;
        double flux;
    };
    void build(std::uint32_t node, std::span<Placed> lights);
    [[nodiscard]] static double brightness(const Node& node, Vec3d p) noexcept;
    [[nodiscard]] double chance_left(const Node& parent, Vec3d p) const noexcept;
    /// Chance that a light at infinity is taken rather than one of the tree.
    [[nodiscard]] double chance_far(Vec3d p) const noexcept;

    std::size_t lights_;
    std::vector<Node> nodes_;          ///< the root first; empty where no light has a place
    std::vector<std::uint32_t> leaf_;  ///< node of each light, none_ for the others
    std::vector<std::uint32_t> far_;   ///< lights at infinity
    std::vector<double> far_cdf_;      ///< of those, by their irradiance; unnormalised
    static constexpr std::uint32_t none = 0xFFFFFFFFU;
};

}  // namespace cardioid
