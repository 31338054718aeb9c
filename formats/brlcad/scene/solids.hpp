#pragma once
#include <optional>
#include <string>

#include "formats/brlcad/database.hpp"
#include "rt_core/scene/solid.hpp"

namespace cardioid::formats::brlcad {

/// Where a solid goes and what came of it.
struct SolidTarget {
    SolidTree& tree;
    Affine place;  ///< of the solid's space in the world
    std::uint32_t material = 0;
    const Database* database = nullptr;  ///< where solids find their sketches
    std::string note{};                  ///< gets why there is no solid, or what of it is approximate
};

/// Adds a solid to the tree and returns its node; nothing, with a note, where it has no volume or is not supported.
/// Formulas: doc of BRL-CAD's primitives (rt_X_prep of each), in the shapes of LeafKind and FormKind.
std::optional<std::uint32_t> add_solid(SolidTarget& target, const Solid& solid);

/// Adds one leaf; nothing where the map onto it has no volume.
std::optional<std::uint32_t> add_leaf(SolidTarget& target, Leaf leaf);

/// A map whose columns are given, and that takes the origin to t.
Affine columns(Vec3d x, Vec3d y, Vec3d z, Vec3d t);
/// The same with z along `axis` and unit columns at right angles.
Affine upright(Vec3d axis, Vec3d t);

std::optional<std::uint32_t> add_arb8(SolidTarget& target, const Solid& solid);
std::optional<std::uint32_t> add_arbn(SolidTarget& target, const Solid& solid);
std::optional<std::uint32_t> add_ars(SolidTarget& target, const Solid& solid);
std::optional<std::uint32_t> add_metaball(SolidTarget& target, const Solid& solid);
/// A dsp, ebm, vol or hf, of a file or an object of the database.
std::optional<std::uint32_t> add_grid(SolidTarget& target, const Solid& solid);
/// A closed mesh; where it is not, or is empty, with a note.
std::optional<std::uint32_t> add_mesh(SolidTarget& target, TriangleMesh mesh);
std::optional<std::uint32_t> add_bot(SolidTarget& target, const Solid& solid);
std::optional<std::uint32_t> add_pipe(SolidTarget& target, const Solid& solid);
std::optional<std::uint32_t> add_extrude(SolidTarget& target, const Solid& solid);
std::optional<std::uint32_t> add_revolve(SolidTarget& target, const Solid& solid);

}  // namespace cardioid::formats::brlcad
