#pragma once
#include <cstdint>
#include <vector>

#include "formats/povray/scene/materials.hpp"
#include "rt_core/math/box.hpp"
#include "rt_core/scene/scene.hpp"

namespace cardioid::formats::povray {

/// What has to be known of each node of the trees before they are written.
struct SolidFacts {
    static constexpr std::uint32_t mixed = 0xFFFFFFFFU;
    struct Node {
        bool empty = false;          ///< makes nothing
        bool transparent = false;    ///< some leaf lets light in
        std::uint32_t material = 0;  ///< of all leaves, or mixed
        int cuts = 0;                ///< how many subtractions this is a subtrahend of, from the root on
        bool abuts = false;          ///< a later part of a transparent union: it must overlap what it touches
    };
    std::vector<Node> nodes;
    std::vector<Box3d> boxes;  ///< around what each node makes

    SolidFacts(const Scene& scene, const Materials& materials);
    /// Children that make something; none of a leaf.
    [[nodiscard]] std::vector<std::uint32_t> children(const SolidTree& solids, std::uint32_t node) const;
};

/// The index of a leaf's material in Materials::all.
inline std::uint32_t material_index(const Leaf& leaf) { return leaf.material == Leaf::no_material ? 0 : leaf.material; }

}  // namespace cardioid::formats::povray
