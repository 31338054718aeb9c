#pragma once
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace cardioid::formats::openscad {

/// What a call is; `light` are the calls of the registry's lights.
enum class Node : std::uint8_t {
    group,
    unite,
    difference,
    intersection,
    render,
    multmatrix,
    translate,
    rotate,
    scale,
    mirror,
    color,
    material,
    cube,
    sphere,
    cylinder,
    polyhedron,
    torus,
    ellipsoid,
    half_space,
    import_file,
    include_mesh,
    surface,
    square,
    circle,
    polygon,
    text,
    hull,
    minkowski,
    resize,
    projection,
    offset,
    fill,
    linear_extrude,
    rotate_extrude,
    roof,
    film,
    camera,
    define_material,
    map_color,
    photons,
    precision,
    end,
    light,
    later  ///< known to the language, not to this version
};

/// A call of the language with the names of its parameters.
struct CallInfo {
    std::string_view name;
    Node node;
    std::vector<std::string_view> positional;  ///< in the order that unnamed arguments fill
    std::vector<std::string_view> named;       ///< can only be given by name
    bool any_arguments = false;                ///< what else is given means nothing, and no warning
};

/// The call of that name, or null.
const CallInfo* find_call(std::string_view name);

/// Every name of the table, for "did you mean".
std::span<const std::string_view> call_names();

/// A solid or plane figure without children.
constexpr bool is_shape(Node node) { return node >= Node::cube && node <= Node::text; }
/// Makes one figure or solid of what its children are, which it sees in a space of their own.
constexpr bool is_operation(Node node) { return node >= Node::hull && node <= Node::fill; }
/// Says something of the scene but makes no solid.
constexpr bool is_setting(Node node) { return node >= Node::film && node <= Node::light; }

}  // namespace cardioid::formats::openscad
