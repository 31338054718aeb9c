#pragma once
#include <map>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>

#include "csg/shapes/facets.hpp"
#include "formats/openscad/evaluate/arguments.hpp"
#include "formats/openscad/evaluate/call_table.hpp"
#include "formats/openscad/limits.hpp"
#include "rt_core/api/format.hpp"
#include "rt_core/scene/solid.hpp"

namespace cardioid::formats::openscad {

/// A leaf before it is placed: `local` carries the leaf's own space to that of the call.
struct Shape {
    LeafKind kind;
    Affine local;
    double a = 0, b = 0;
    std::uint32_t data = 0;
};

/// What the makers of shapes share while a file is read.
struct ShapeContext {
    SolidTree& solids;
    const ReadOptions& options;
    const std::string& base_dir;
    Warnings& warnings;
    Limits limits{};
    std::unordered_map<std::string, std::uint32_t> mesh_files{};  ///< index into SolidTree::meshes by path
    std::set<std::uint32_t> hulls{};                              ///< meshes that are convex by their making
    std::map<int, std::uint32_t> balls{};                         ///< faceted unit spheres by their facets
    std::map<int, std::uint32_t> cones{};                         ///< faceted unit cones
    std::map<int, std::uint32_t> discs{};                         ///< regular n-gons of radius 1: SolidTree::profiles
};

/// $fn, $fa and $fs of a call.
csg::FacetSettings facet_settings(const Arguments& arguments);

/// Whether a call makes a true curve: --facets=auto and $fn 0 or at least --smooth-from.
bool is_curved(const csg::FacetSettings& facets, const ReadOptions& options);

/// A profile up to this many edges is met analytically, as LeafKind::prism or LeafKind::revolution.
inline constexpr std::size_t most_profile_edges = 64;
std::size_t edge_count(const Profile& profile);

/// The shape of a solid's call; nothing, and a warning, where it is empty. Throws Error(bad_input) for arguments of a
/// wrong type, Error(io) for an include_mesh() that is missing; of an import() that is a warning.
std::optional<Shape> make_solid(Node node, const Arguments& arguments, ShapeContext& context);

/// A mesh made sound, as a leaf; a warning where it has holes. Nothing where it has no triangles.
std::optional<Shape> make_mesh(TriangleMesh mesh, const std::string& where, ShapeContext& context);

/// polyhedron(points, faces), polyhedron.cpp.
std::optional<Shape> make_polyhedron(const Arguments& arguments, ShapeContext& context);

}  // namespace cardioid::formats::openscad
