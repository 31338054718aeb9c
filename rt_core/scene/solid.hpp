#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "rt_core/math/affine.hpp"
#include "rt_core/scene/profile.hpp"
#include "rt_core/scene/solid_op.hpp"
#include "rt_core/scene/triangle_mesh.hpp"

namespace cardioid {

/// The shapes a ray meets. Each stands in its own local space; Leaf::to_world places it.
enum class LeafKind : std::uint8_t {
    box,         ///< 0 <= x,y,z <= 1
    sphere,      ///< x^2 + y^2 + z^2 <= 1: balls and ellipsoids
    cone,        ///< 0 <= z <= 1, radius from `a` at z = 0 to `b` at z = 1: cylinders, cones, frusta
    torus,       ///< ring of radius `a` about z, tube radius `b` < a
    half_space,  ///< z <= 0
    prism,       ///< profile x [0, 1] along z; at z = 1 the profile is scaled by `a` (0 < a; 1 is a straight prism)
    revolution,  ///< profile in (x = distance from the z axis >= 0, y = z) turned about z
    mesh,        ///< closed triangle mesh
    form         ///< a Form
};

/// Shapes by a formula; w, n ... are Form::numbers in this order.
enum class FormKind : std::uint8_t {
    bowl,            ///< 0 <= z <= 1, x^2 + y^2 <= w u^2 + (1 - w) u, u = 1 - z, 0 <= w < 1: paraboloid, hyperboloid
    trough,          ///< the same with 0 <= y <= 1 and x^2 alone on the left
    waist,           ///< -1 <= z <= 1, x^2 + y^2 <= n + (1 - n) z^2, 0 < n < 1: hyperboloid of one sheet
    taper,           ///< 0 <= z <= 1, (x / (1 + (c - 1) z))^2 + (y / (1 + (d - 1) z))^2 <= 1, c and d >= 0
    tilted_ring,     ///< A r^2 + B r z + C z^2 <= 1 with r = sqrt(x^2 + y^2) - R: numbers R, A, B, C; r > -R inside
    superellipsoid,  ///< (|x|^(2/e) + |y|^(2/e))^(e/n) + |z|^(2/n) <= 1, n and e > 0
    metaball  ///< within -1 and 1, the sum over Form::blobs of fields f(r) >= threshold: numbers method, threshold
};

/// A point of a metaball. Its field at distance r by the method, with s for strength, negative if s is:
/// 0: 1 - 3 (r/s)^2 up to s/3, 1.5 (1 - r/s)^2 up to s, then 0 (Nishimura et al. 1985); 1: (s/r)^2;
/// 2: exp(k (1 - (r/s)^2)) (Blinn 1982).
struct Blob {
    Vec3d centre;
    double strength = 1;   ///< s, not 0
    double sharpness = 1;  ///< k > 0, of method 2
};

struct Form {
    FormKind kind = FormKind::bowl;
    std::array<double, 4> numbers{};
    std::shared_ptr<const std::vector<Blob>> blobs{};  ///< of a metaball
};

struct Leaf {
    static constexpr std::uint32_t no_material = 0xFFFFFFFFU;
    LeafKind kind = LeafKind::box;
    Affine to_world;                       ///< determinant is not zero; negative mirrors
    double a = 0, b = 0;                   ///< as said at LeafKind
    std::uint32_t data = 0;                ///< index into SolidTree::profiles, ::meshes or ::forms
    std::uint32_t material = no_material;  ///< index into Scene::materials
    std::uint32_t line = 0;                ///< of the scene file
};

/// A node; its children are SolidTree::children[first .. first + count).
struct SolidNode {
    SolidOp op = SolidOp::unite;
    std::uint32_t first = 0, count = 0;
};

/// Boolean trees as flat arrays: children stand before their parents, so every walk is a loop and depth costs no stack.
struct SolidTree {
    std::vector<SolidNode> nodes;
    std::vector<std::uint32_t> children;  ///< indices into nodes
    std::vector<std::uint32_t> roots;     ///< nodes whose union is the model
    std::vector<Leaf> leaves;
    std::vector<std::shared_ptr<const Profile>> profiles;
    std::vector<std::shared_ptr<const TriangleMesh>> meshes;
    std::vector<Form> forms;

    /// Adds a node over one leaf and returns the node's index.
    std::uint32_t add_leaf(const Leaf& leaf) {
        leaves.push_back(leaf);
        nodes.push_back({SolidOp::leaf, static_cast<std::uint32_t>(leaves.size() - 1), 1});
        return static_cast<std::uint32_t>(nodes.size() - 1);
    }
    /// Adds a node over existing ones and returns its index.
    std::uint32_t add_node(SolidOp op, const std::vector<std::uint32_t>& over) {
        nodes.push_back({op, static_cast<std::uint32_t>(children.size()), static_cast<std::uint32_t>(over.size())});
        children.insert(children.end(), over.begin(), over.end());
        return static_cast<std::uint32_t>(nodes.size() - 1);
    }
    std::uint32_t add_profile(Profile profile) {
        profiles.push_back(std::make_shared<const Profile>(std::move(profile)));
        return static_cast<std::uint32_t>(profiles.size() - 1);
    }
    std::uint32_t add_mesh(TriangleMesh mesh) {
        meshes.push_back(std::make_shared<const TriangleMesh>(std::move(mesh)));
        return static_cast<std::uint32_t>(meshes.size() - 1);
    }
    std::uint32_t add_form(const Form& form) {
        forms.push_back(form);
        return static_cast<std::uint32_t>(forms.size() - 1);
    }
};

}  // namespace cardioid
