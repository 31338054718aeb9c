#include "rt_core/render/commit/scene_digest.hpp"

#include <bit>

#include "rt_core/math/sampler.hpp"

namespace cardioid {

namespace {

/// Mixes a sequence of values into 64 bits.
class Hasher {
public:
    void add(std::uint64_t x) { state_ = mix64(state_ ^ x); }
    /// -0 counts as 0: both mean the same place.
    void add(double x) { add(std::bit_cast<std::uint64_t>(x == 0 ? 0.0 : x)); }
    void add(Vec3d v) { add(v.x), add(v.y), add(v.z); }
    void add(const std::string& text) {
        add(std::uint64_t{text.size()});
        for (const char c : text) add(std::uint64_t{static_cast<unsigned char>(c)});
    }
    void add(const Affine& m) { add(m.row[0]), add(m.row[1]), add(m.row[2]), add(m.t); }
    void add(const Params& params) {
        for (const auto& [name, value] : params.all()) {
            add(name);
            add(static_cast<std::uint64_t>(value.kind));
            add(std::uint64_t{value.numbers.size()});
            for (const double x : value.numbers) add(x);
            add(value.text);
            add(std::uint64_t{value.boolean});
        }
    }
    void add(const Profile& profile) {
        for (const auto& contour : profile.contours) {
            add(std::uint64_t{contour.size()});
            for (const Vec2d p : contour) add(p.x), add(p.y);
        }
    }
    void add(const TriangleMesh& mesh) {
        add(std::uint64_t{mesh.vertices.size()});
        for (const Vec3d v : mesh.vertices) add(v);
        for (const auto& t : mesh.triangles) add(std::uint64_t{t[0]} << 32 | t[1]), add(std::uint64_t{t[2]});
    }
    [[nodiscard]] std::uint64_t value() const { return state_; }

private:
    std::uint64_t state_ = 0;
};

void add_solids(Hasher& hash, const SolidTree& solids) {
    for (const SolidNode& node : solids.nodes) {
        hash.add(static_cast<std::uint64_t>(node.op));
        hash.add(std::uint64_t{node.first} << 32 | node.count);
    }
    for (const std::uint32_t child : solids.children) hash.add(std::uint64_t{child});
    for (const std::uint32_t root : solids.roots) hash.add(std::uint64_t{root});
    for (const Leaf& leaf : solids.leaves) {
        hash.add(static_cast<std::uint64_t>(leaf.kind));
        hash.add(leaf.to_world);
        hash.add(leaf.a), hash.add(leaf.b);
        hash.add(std::uint64_t{leaf.data} << 32 | leaf.material);
    }
    for (const auto& profile : solids.profiles) hash.add(*profile);
    for (const auto& mesh : solids.meshes) hash.add(*mesh);
    for (const Form& form : solids.forms) {
        hash.add(static_cast<std::uint64_t>(form.kind));
        for (const double x : form.numbers) hash.add(x);
        if (!form.blobs) continue;
        for (const Blob& blob : *form.blobs) hash.add(blob.centre), hash.add(blob.strength), hash.add(blob.sharpness);
    }
}

std::size_t edges(const Profile& profile) {
    std::size_t n = 0;
    for (const auto& contour : profile.contours) n += contour.size();
    return n;
}

}  // namespace

std::uint64_t scene_hash(const Scene& scene) {
    Hasher hash;
    add_solids(hash, scene.solids);
    for (const MaterialSettings& m : scene.materials) {
        hash.add(m.name);
        hash.add(m.kind);
        hash.add(m.params);
    }
    for (const LightSettings& light : scene.lights) {
        hash.add(light.kind);
        hash.add(light.params);
        hash.add(light.to_world);
    }
    return hash.value();
}

std::size_t face_count(const SolidTree& solids) {
    std::size_t n = 0;
    for (const Leaf& leaf : solids.leaves) switch (leaf.kind) {
            case LeafKind::box:
                n += 6;
                break;
            case LeafKind::sphere:
            case LeafKind::torus:
            case LeafKind::half_space:
                n += 1;
                break;
            case LeafKind::cone:
                n += 1 + (leaf.a > 0 ? 1U : 0U) + (leaf.b > 0 ? 1U : 0U);
                break;
            case LeafKind::prism:
                n += 2 + edges(*solids.profiles[leaf.data]);
                break;
            case LeafKind::revolution:
                n += edges(*solids.profiles[leaf.data]);
                break;
            case LeafKind::mesh:
                n += solids.meshes[leaf.data]->triangles.size();
                break;
            case LeafKind::form:
                n += 2;
                break;
        }
    return n;
}

}  // namespace cardioid
