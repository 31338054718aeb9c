#include "formats/openscad/evaluate/call_table.hpp"

#include <unordered_map>

namespace cardioid::formats::openscad {
namespace {

std::vector<std::string_view> words(std::string_view list) {
    std::vector<std::string_view> out;
    while (!list.empty()) {
        const std::size_t space = list.find(' ');
        out.push_back(list.substr(0, space));
        list = space == std::string_view::npos ? std::string_view{} : list.substr(space + 1);
    }
    return out;
}

struct Row {
    const char* name;
    Node node;
    const char* positional = "";
    const char* named = "";
    bool any_arguments = false;
};

/// Parameters in the order of OpenSCAD 2021.01; `convexity` concerns its preview only.
constexpr Row rows[] = {
    {"group", Node::group, "", "", true},
    {"union", Node::unite, "", "", true},
    {"difference", Node::difference, "", "", true},
    {"intersection", Node::intersection, "", "", true},
    {"render", Node::render, "convexity", "", true},
    {"multmatrix", Node::multmatrix, "m"},
    {"translate", Node::translate, "v"},
    {"rotate", Node::rotate, "a v"},
    {"scale", Node::scale, "v"},
    {"mirror", Node::mirror, "v"},
    {"color", Node::color, "c alpha"},
    {"material", Node::material, "name"},
    {"cube", Node::cube, "size center"},
    {"sphere", Node::sphere, "r", "d"},
    {"cylinder", Node::cylinder, "h r1 r2 center", "r d d1 d2"},
    {"polyhedron", Node::polyhedron, "points faces convexity", "triangles"},
    {"torus", Node::torus, "R r"},
    {"ellipsoid", Node::ellipsoid, "radii"},
    {"half_space", Node::half_space, "n d"},
    {"import", Node::import_file, "file layer convexity origin scale",
     "width height filename layername center dpi timestamp id"},
    {"include_mesh", Node::include_mesh, "file"},
    {"square", Node::square, "size center"},
    {"circle", Node::circle, "r", "d"},
    {"polygon", Node::polygon, "points paths convexity"},
    {"linear_extrude", Node::linear_extrude, "height",
     "h v center convexity twist slices segments scale file layer origin timestamp"},
    {"rotate_extrude", Node::rotate_extrude, "angle", "start convexity file layer origin scale timestamp"},
    {"text", Node::text, "text size font", "direction language script halign valign spacing"},
    {"surface", Node::surface, "file center convexity", "invert timestamp"},
    {"hull", Node::hull, "", "", true},
    {"minkowski", Node::minkowski, "convexity"},
    {"resize", Node::resize, "newsize auto convexity"},
    {"projection", Node::projection, "cut convexity", "timestamp"},
    {"offset", Node::offset, "r", "delta chamfer join_type miter_limit"},
    {"fill", Node::fill, "", "", true},
    {"film", Node::film, "size samples exposure"},
    {"camera", Node::camera, "eye", "look_at up fov fov_axis lens_radius focus shutter name projection width"},
    {"define_material", Node::define_material},
    {"map_color", Node::map_color, "color material"},
    {"photons", Node::photons, "", "", true},
    {"precision", Node::precision, "digits"},
    {"end", Node::end},
    {"roof", Node::roof, "method convexity"},
    {"animate", Node::later},
    {"import_stl", Node::import_file, "file layer convexity origin scale", "filename layername center timestamp"},
    {"import_off", Node::import_file, "file layer convexity origin scale", "filename layername center timestamp"},
    {"import_dxf", Node::import_file, "file layer convexity origin scale", "filename layername center timestamp"},
    {"dxf_linear_extrude", Node::linear_extrude, "file layer height origin scale center twist slices",
     "h convexity timestamp"},
    {"dxf_rotate_extrude", Node::rotate_extrude, "file layer origin scale", "angle start convexity timestamp"},
};

struct Table {
    std::unordered_map<std::string_view, CallInfo> calls;
    std::vector<std::string_view> names;
    Table() {
        for (const Row& row : rows) {
            calls.emplace(row.name, CallInfo{row.name, row.node, words(row.positional), words(row.named),
                                             row.any_arguments || row.node == Node::later});
            names.emplace_back(row.name);
        }
    }
};

const Table& table() {
    static const Table instance;
    return instance;
}

}  // namespace

const CallInfo* find_call(std::string_view name) {
    const auto at = table().calls.find(name);
    return at == table().calls.end() ? nullptr : &at->second;
}

std::span<const std::string_view> call_names() { return table().names; }

}  // namespace cardioid::formats::openscad
