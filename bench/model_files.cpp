#include "bench/model_files.hpp"

#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace cardioid::bench {
namespace {

/// A white surface that faces the eye has this radiance in the middle of the picture.
constexpr double middle_radiance = 0.4;
/// Beyond this distance POV-Ray's light falls off with the square.
constexpr double fade_distance = 1e-3;

/// W/sr of the lamp at the eye: L = I / (pi d^2) on white.
double intensity(const View& view) {
    const Vec3d v = view.target - view.eye;
    return middle_radiance * std::numbers::pi * dot(v, v);
}

std::string csg_matrix(const Affine& m) {
    std::string rows;
    for (int i = 0; i < 3; ++i) {
        const Vec3d& r = m.row[static_cast<std::size_t>(i)];
        rows += fmt::format("[{:.9g},{:.9g},{:.9g},{:.9g}],", r.x, r.y, r.z, m.t[i]);
    }
    return "multmatrix([" + rows + "[0,0,0,1]]) ";
}

std::string csg_leaf(const Leaf& leaf) {
    switch (leaf.kind) {
        case LeafKind::sphere:
            return csg_matrix(leaf.to_world) + "sphere(r = 1);\n";
        case LeafKind::cone:
            return csg_matrix(leaf.to_world) +
                   fmt::format("cylinder(h = 1, r1 = {:.9g}, r2 = {:.9g});\n", leaf.a, leaf.b);
        default:
            return csg_matrix(leaf.to_world) + "cube([1, 1, 1]);\n";
    }
}

std::string pov_vector(const Vec3d& v) { return fmt::format("<{:.9g},{:.9g},{:.9g}>", v.x, v.y, v.z); }

std::string pov_matrix(const Affine& m) {
    std::string text = " matrix <";
    for (int i = 0; i < 3; ++i) {
        const Vec3d c = m.column(i);
        text += fmt::format("{:.9g},{:.9g},{:.9g},", c.x, c.y, c.z);
    }
    return text + fmt::format("{:.9g},{:.9g},{:.9g}>", m.t.x, m.t.y, m.t.z);
}

bool is_diagonal(const Affine& m) {
    return m.row[0].y == 0 && m.row[0].z == 0 && m.row[1].x == 0 && m.row[1].z == 0 && m.row[2].x == 0 &&
           m.row[2].y == 0;
}

std::string pov_leaf(const Leaf& leaf) {
    const Affine& m = leaf.to_world;
    switch (leaf.kind) {
        case LeafKind::sphere:
            return fmt::format("sphere {{ {}, {:.9g} }}\n", pov_vector(m.t), length(m.column(0)));
        case LeafKind::cone:
            return fmt::format("cone {{ <0,0,0>, {:.9g}, <0,0,1>, {:.9g}{} }}\n", leaf.a, leaf.b, pov_matrix(m));
        default:
            if (is_diagonal(m))
                return fmt::format("box {{ {}, {} }}\n", pov_vector(m.t), pov_vector(m.point({1, 1, 1})));
            return "box { <0,0,0>, <1,1,1>" + pov_matrix(m) + " }\n";
    }
}

/// How a language spells an operation.
struct Language {
    std::string (*leaf)(const Leaf&);
    const char *unite, *subtract, *intersect, *close;
    bool flat_chains;  ///< (A - B) - C is written A - B - C
};
constexpr Language csg_language{csg_leaf, "union() {\n", "difference() {\n", "intersection() {\n", "}\n", false};
constexpr Language pov_language{pov_leaf, "union {\n", "difference {\n", "intersection {\n", "}\n", true};

void append_children(const SolidTree& tree, const SolidNode& node, const Language& language, std::string& text);

void append_node(const SolidTree& tree, std::uint32_t index, const Language& language, std::string& text) {
    const SolidNode& node = tree.nodes[index];
    if (node.op == SolidOp::leaf) {
        text += language.leaf(tree.leaves[node.first]);
        return;
    }
    text += node.op == SolidOp::unite      ? language.unite
            : node.op == SolidOp::subtract ? language.subtract
                                           : language.intersect;
    append_children(tree, node, language, text);
    text += language.close;
}

void append_children(const SolidTree& tree, const SolidNode& node, const Language& language, std::string& text) {
    for (std::uint32_t i = 0; i < node.count; ++i) {
        const std::uint32_t child = tree.children[node.first + i];
        const SolidNode& below = tree.nodes[child];
        if (i == 0 && language.flat_chains && node.op == SolidOp::subtract && below.op == SolidOp::subtract)
            append_children(tree, below, language, text);
        else
            append_node(tree, child, language, text);
    }
}

std::string roots(const Model& model, const Language& language) {
    std::string text;
    for (const std::uint32_t root : model.solids.roots) append_node(model.solids, root, language, text);
    return text;
}

std::string csg_list(const Vec3d& v) { return fmt::format("[{:.9g}, {:.9g}, {:.9g}]", v.x, v.y, v.z); }

}  // namespace

std::string as_csg(const Model& model) {
    const View& v = model.view;
    return fmt::format(
               "film([512, 512], samples = 1);\n"
               "camera({}, look_at = {}, fov = {:.9g});\n"
               "multmatrix([[1,0,0,{:.9g}],[0,1,0,{:.9g}],[0,0,1,{:.9g}],[0,0,0,1]]) "
               "point_light(intensity = {:.9g}, shadows = false);\n"
               "define_material(\"white\", kind = \"diffuse\", reflectance = 1);\n"
               "material(\"white\") {{\n",
               csg_list(v.eye), csg_list(v.target), v.fov_deg, v.eye.x, v.eye.y, v.eye.z, intensity(v)) +
           roots(model, csg_language) + "}\n";
}

std::string as_pov(const Model& model) {
    const View& v = model.view;
    return fmt::format(
               "#version 3.7;\n"
               "global_settings {{ assumed_gamma 1.0 adc_bailout 0 max_trace_level 32 }}\n"
               "#default {{ finish {{ ambient 0 diffuse 1 }} pigment {{ color rgb 1 }} }}\n"
               "#declare Eye = {};\n#declare F = vnormalize({} - Eye);\n"
               "#declare R = vnormalize(vcross(F, z));\n#declare U = vcross(R, F);\n"
               "camera {{ location Eye direction F * 0.5 / tan(radians({:.9g}) / 2) right R up U }}\n"
               "light_source {{ Eye color rgb {:.9g} shadowless fade_distance {:.9g} fade_power 2 }}\n",
               pov_vector(v.eye), pov_vector(v.target), v.fov_deg,
               intensity(v) / std::numbers::pi / (2 * fade_distance * fade_distance), fade_distance) +
           roots(model, pov_language);
}

}  // namespace cardioid::bench
