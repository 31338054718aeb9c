#include "formats/openscad/scene_writer.hpp"

#include <unordered_set>

#include "csg/exact/tessellate.hpp"
#include "formats/openscad/evaluate/materials.hpp"
#include "formats/openscad/syntax/ast.hpp"
#include "formats/openscad/syntax/printer.hpp"

namespace cardioid::formats::openscad {
namespace {

/// Shapes that the language has no word for are written in chords; in their own space they are about 2 across.
constexpr double chord_share = 1e-3;

class SceneWriter {
public:
    explicit SceneWriter(const Scene& scene) : scene_(scene), build_(ast_) {}

    std::string run() {
        call("precision", [&] { build_.argument("digits", build_.number(scene_.six_digits ? 6 : 17)); });
        film();
        for (const CameraSettings& camera : scene_.cameras) write_camera(camera);
        materials();
        if (!scene_.photons.all().empty()) call("photons", [&] { params(scene_.photons); });
        for (const LightSettings& light : scene_.lights) {
            const bool moved = open_matrix(light.to_world);
            call(light.kind.c_str(), [&] { params(light.params); });
            if (moved) build_.close();
        }
        solids();
        return print(ast_);
    }

private:
    template <class Arguments>
    void call(const char* name, Arguments&& arguments) {
        build_.open(name);
        arguments();
        build_.close();
    }

    void number(const char* name, double x) { build_.argument(name, build_.number(x)); }
    void vector(const char* name, Vec3d v) {
        const double xs[] = {v.x, v.y, v.z};
        build_.argument(name, build_.numbers(xs));
    }
    void text(const char* name, const std::string& s) { build_.argument(name, build_.string(s)); }

    void params(const Params& params) {
        for (const auto& [name, value] : params.all()) {
            switch (value.kind) {
                case ParamValue::Kind::text:
                    text(name.c_str(), value.text);
                    break;
                case ParamValue::Kind::boolean:
                    build_.argument(name, AstBuilder::boolean(value.boolean));
                    break;
                case ParamValue::Kind::numbers:
                    if (value.list)
                        build_.argument(name, build_.numbers(value.numbers));
                    else
                        number(name.c_str(), value.numbers[0]);
            }
        }
    }

    void film() {
        const FilmSettings& film = scene_.film;
        if (!film.width && !film.samples && film.exposure == 0) return;
        call("film", [&] {
            if (film.width && film.height) {
                const double size[] = {static_cast<double>(*film.width), static_cast<double>(*film.height)};
                build_.argument("size", build_.numbers(size));
            }
            if (film.samples) number("samples", *film.samples);
            if (film.exposure != 0) number("exposure", film.exposure);
        });
    }

    void write_camera(const CameraSettings& camera) {
        call("camera", [&] {
            vector("eye", camera.eye);
            vector("look_at", camera.look_at);
            vector("up", camera.up);
            number("fov", camera.fov_deg);
            if (camera.fov_is_horizontal) text("fov_axis", "x");
            if (camera.lens_radius != 0) number("lens_radius", camera.lens_radius);
            if (camera.focus != 0) number("focus", camera.focus);
            text("name", camera.name);
            if (camera.projection == CameraSettings::Projection::orthographic) {
                text("projection", "orthographic");
                number("width", camera.width);
            }
        });
    }

    /// Names as they are where they can be told apart; a scene of another format may have none.
    void materials() {
        std::unordered_set<std::string> taken;
        for (std::size_t i = 0; i < scene_.materials.size(); ++i) {
            const MaterialSettings& material = scene_.materials[i];
            std::string name = i == 0 ? "default" : material.name.empty() ? "material" : material.name;
            while (!taken.insert(name).second) name.append("_").append(std::to_string(i));
            names_.push_back(name);
            call("define_material", [&] {
                build_.argument("", build_.string(name));
                text("kind", material.kind);
                params(material.params);
            });
        }
    }

    bool open_matrix(const Affine& m) {
        if (m == Affine{}) return false;
        build_.open("multmatrix");
        Value rows[4];
        for (int i = 0; i < 3; ++i) {
            const Vec3d& r = m.row[static_cast<std::size_t>(i)];
            const double row[] = {r.x, r.y, r.z, m.t[i]};
            rows[i] = build_.numbers(row);
        }
        static constexpr double last[] = {0, 0, 0, 1};
        rows[3] = build_.numbers(last);
        build_.argument("", build_.list(rows));
        return true;
    }

    /// The trees, with a stack of the nodes that are open.
    void solids() {
        const SolidTree& tree = scene_.solids;
        struct Open {
            const std::uint32_t* next;
            const std::uint32_t* end;
        };
        std::vector<Open> open{{tree.roots.data(), tree.roots.data() + tree.roots.size()}};
        while (!open.empty()) {
            Open& top = open.back();
            if (top.next == top.end) {
                open.pop_back();
                if (!open.empty()) build_.close();
                continue;
            }
            const SolidNode& node = tree.nodes[*top.next++];
            if (node.op == SolidOp::leaf) {
                leaf(tree.leaves[node.first]);
                continue;
            }
            build_.open(node.op == SolidOp::unite       ? "union"
                        : node.op == SolidOp::intersect ? "intersection"
                                                        : "difference");
            const std::uint32_t* const first = tree.children.data() + node.first;
            open.push_back({first, first + node.count});
        }
    }

    void leaf(const Leaf& leaf) {
        const bool has_material = leaf.material < names_.size();
        if (has_material) {
            build_.open("material");
            build_.argument("", build_.string(names_[leaf.material]));
        }
        const bool moved = open_matrix(leaf.to_world);
        shape(leaf);
        if (moved) build_.close();
        if (has_material) build_.close();
    }

    void shape(const Leaf& leaf) {
        switch (leaf.kind) {
            case LeafKind::box:
                call("cube", [&] { vector("size", {1, 1, 1}); });
                break;
            case LeafKind::sphere:
                call("sphere", [&] { number("r", 1); });
                break;
            case LeafKind::cone:
                call("cylinder", [&] { number("h", 1), number("r1", leaf.a), number("r2", leaf.b); });
                break;
            case LeafKind::torus:
                call("torus", [&] { number("R", leaf.a), number("r", leaf.b); });
                break;
            case LeafKind::half_space:
                call("half_space", [&] { vector("n", {0, 0, 1}), number("d", 0); });
                break;
            case LeafKind::prism:
                build_.open("linear_extrude");
                number("height", 1);
                if (leaf.a != 1) number("scale", leaf.a);
                polygon(*scene_.solids.profiles[leaf.data]);
                build_.close();
                break;
            case LeafKind::revolution:
                build_.open("rotate_extrude");
                polygon(*scene_.solids.profiles[leaf.data]);
                build_.close();
                break;
            case LeafKind::mesh:
                polyhedron(*scene_.solids.meshes[leaf.data]);
                break;
            case LeafKind::form: {
                const Leaf own{.kind = leaf.kind, .data = leaf.data};
                polyhedron(csg::tessellate(scene_.solids, own, chord_share));
                break;
            }
        }
    }

    void polygon(const Profile& profile) {
        std::vector<Value> points, paths;
        double index = 0;
        for (const auto& contour : profile.contours) {
            std::vector<double> path;
            for (const Vec2d p : contour) {
                const double xy[] = {p.x, p.y};
                points.push_back(build_.numbers(xy));
                path.push_back(index++);
            }
            paths.push_back(build_.numbers(path));
        }
        call("polygon", [&] {
            build_.argument("points", build_.list(points));
            build_.argument("paths", build_.list(paths));
        });
    }

    /// OpenSCAD's faces run clockwise seen from outside.
    void polyhedron(const TriangleMesh& mesh) {
        std::vector<Value> points, faces;
        points.reserve(mesh.vertices.size());
        faces.reserve(mesh.triangles.size());
        for (const Vec3d& p : mesh.vertices) {
            const double xyz[] = {p.x, p.y, p.z};
            points.push_back(build_.numbers(xyz));
        }
        for (const auto& t : mesh.triangles) {
            const double face[] = {static_cast<double>(t[2]), static_cast<double>(t[1]), static_cast<double>(t[0])};
            faces.push_back(build_.numbers(face));
        }
        call("polyhedron", [&] {
            build_.argument("points", build_.list(points));
            build_.argument("faces", build_.list(faces));
        });
    }

    const Scene& scene_;
    Ast ast_;
    AstBuilder build_;
    std::vector<std::string> names_;  ///< of the materials, each once
};

}  // namespace

std::string write_scene(const Scene& scene, const WriteOptions&) { return SceneWriter(scene).run(); }

}  // namespace cardioid::formats::openscad
