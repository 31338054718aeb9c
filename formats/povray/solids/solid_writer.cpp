#include "formats/povray/solids/solid_writer.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>

#include "formats/povray/solids/bounds.hpp"
#include "formats/povray/solids/coincidence.hpp"

namespace cardioid::formats::povray {

namespace {

/// Share of the scene's diagonal by which sides that would coincide are moved apart: far below a pixel, and above the
/// 1e-4 units that POV-Ray takes for nothing.
constexpr double growth_share = 1e-6;
/// How far a checker's pattern is moved into the solid, in fields, as kind `checker` has it.
constexpr double checker_depth = 1e-4;

class SolidWriter {
public:
    SolidWriter(const Scene& scene, const SolidSettings& settings, Notes& notes)
        : scene_(scene),
          solids_(scene.solids),
          settings_(settings),
          notes_(notes),
          facts_(scene, settings.materials),
          growths_(
              find_growths(solids_, facts_, settings.diagonal, growth_share * settings.diagonal * settings.scale)) {}

    std::string run() {
        for (const std::uint32_t root : solids_.roots)
            if (!facts_.nodes[root].empty) write_root(root);
        note_overlaps();
        return std::move(text_);
    }

private:
    [[nodiscard]] const Material& material(std::uint32_t index) const { return settings_.materials.all[index]; }

    /// Light goes through glass unbent in POV-Ray's shadow rays. Where ours end at it, it casts no shadow itself, and a
    /// black twin of it that nobody sees casts that.
    void write_root(std::uint32_t root) {
        bool opaque = false, target = false;
        for_leaves(root, [&](const Leaf& leaf) {
            opaque = opaque || material(material_index(leaf)).opaque_shadow;
            target = target || material(material_index(leaf)).photon_target;
        });
        opaque = opaque && !settings_.photons;
        std::string flags = opaque ? " no_shadow" : "";
        if (target && settings_.photons) flags += " photons { target reflection on refraction on }";
        write(root, true, flags);
        if (opaque) write(root, false, " pigment { rgb 0 } no_image no_reflection no_radiosity");
    }

    template <class Use>
    void for_leaves(std::uint32_t root, Use&& use) const {
        std::vector<std::uint32_t> open{root};
        while (!open.empty()) {
            const std::uint32_t node = open.back();
            open.pop_back();
            if (solids_.nodes[node].op == SolidOp::leaf) {
                use(solids_.leaves[solids_.nodes[node].first]);
                continue;
            }
            const std::vector<std::uint32_t> children = facts_.children(solids_, node);
            open.insert(open.end(), children.begin(), children.end());
        }
    }

    /// A node that is open: its children are being written.
    struct Open {
        std::vector<std::uint32_t> children;
        std::size_t next;
        std::string end;  ///< what stands before the closing brace
        bool textured;    ///< children say what they are made of
    };

    void write(std::uint32_t root, bool textured, const std::string& flags) {
        std::vector<Open> open;
        begin(root, textured, flags, open);
        while (!open.empty()) {
            Open& top = open.back();
            if (top.next < top.children.size()) {
                begin(top.children[top.next++], top.textured, "", open);
                continue;
            }
            indent(open.size() - 1);
            const std::string end = std::move(top.end);
            open.pop_back();
            text_ += end.empty() ? "}\n" : end.substr(1) + " }\n";
        }
    }

    void indent(std::size_t depth) { text_.append(depth * 2, ' '); }

    void begin(std::uint32_t node, bool textured, std::string end, std::vector<Open>& open) {
        std::vector<std::uint32_t> children = facts_.children(solids_, node);
        while (solids_.nodes[node].op != SolidOp::leaf && children.size() == 1) {
            node = children[0];
            children = facts_.children(solids_, node);
        }
        const std::uint32_t only = facts_.nodes[node].material;
        indent(open.size());
        if (solids_.nodes[node].op == SolidOp::leaf) {
            const Leaf& leaf = solids_.leaves[solids_.nodes[node].first];
            text_ += shape(leaf, solids_, settings_.scale, growths_[node]);
            if (textured) text_ += made_of(only, checker_place(leaf, node));
            text_ += fmt::format("{} }}  // {}\n", end, leaf.line);
            return;
        }
        if (textured && only != SolidFacts::mixed && material(only).field == 0) {
            end = made_of(only, "") + end;
            textured = false;
        }
        text_ += keyword(node);
        text_ += " {\n";
        open.push_back({std::move(children), 0, std::move(end), textured});
    }

    [[nodiscard]] const char* keyword(std::uint32_t node) const {
        switch (solids_.nodes[node].op) {
            case SolidOp::intersect:
                return "intersection";
            case SolidOp::subtract:
                return "difference";
            default:
                return facts_.nodes[node].transparent ? "merge" : "union";
        }
    }

    [[nodiscard]] std::string made_of(std::uint32_t index, const std::string& place) const {
        const Material& m = material(index);
        const std::string interior = m.interior.empty() ? "" : fmt::format(" interior {{ {} }} hollow", m.interior);
        return fmt::format(" texture {{ {}{} }}{}", m.texture, place, interior);
    }

    /// The pattern of a checker is drawn into the solid from all sides, so that a face on a border of fields shows
    /// those inside; a subtrahend's inside is out of it.
    [[nodiscard]] std::string checker_place(const Leaf& leaf, std::uint32_t node) const {
        const double field = material(material_index(leaf)).field;
        if (field == 0) return "";
        const double depth = checker_depth * field * (facts_.nodes[node].cuts % 2 == 0 ? 1 : -1);
        const Affine& m = leaf.to_world;
        if (leaf.kind == LeafKind::half_space) {
            const Vec3d n = normalize(cross(m.column(0), m.column(1)) * (m.determinant() > 0 ? 1.0 : -1.0));
            return fmt::format(" translate {}", sdl(n * depth));
        }
        const Box3d box = world_box(leaf, solids_);
        const Vec3d c = box.centre() * settings_.scale, half = box.size() * (settings_.scale / 2);
        const Vec3d times{1 + depth / half.x, 1 + depth / half.y, 1 + depth / half.z};
        return fmt::format(" translate {} scale {} translate {}", sdl(-c), sdl(times), sdl(c));
    }

    /// Where transparent solids overlap the boxes do too.
    void note_overlaps() {
        constexpr std::size_t most_compared = 2000;
        std::vector<std::uint32_t> roots;
        for (const std::uint32_t root : solids_.roots)
            if (!facts_.nodes[root].empty && facts_.nodes[root].transparent && roots.size() < most_compared)
                roots.push_back(root);
        for (std::size_t i = 0; i < roots.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                if (facts_.boxes[roots[i]].overlaps(facts_.boxes[roots[j]]))
                    notes_.add(fmt::format("{}:{}", scene_.file, first_line(roots[i])),
                               fmt::format("a transparent solid may overlap that of line {}; POV-Ray has both there",
                                           first_line(roots[j])));
    }

    [[nodiscard]] std::uint32_t first_line(std::uint32_t node) const {
        while (solids_.nodes[node].op != SolidOp::leaf) node = facts_.children(solids_, node).front();
        return solids_.leaves[solids_.nodes[node].first].line;
    }

    const Scene& scene_;
    const SolidTree& solids_;
    const SolidSettings& settings_;
    Notes& notes_;
    SolidFacts facts_;
    std::vector<Growth> growths_;
    std::string text_;
};

/// The scene with its roots of one glass put together where they may overlap: between equal media there is no face.
Scene with_glass_merged(const Scene& scene, const Materials& materials) {
    const SolidFacts facts(scene, materials);
    std::map<std::uint32_t, std::vector<std::uint32_t>> of_material;
    for (const std::uint32_t root : scene.solids.roots) {
        const SolidFacts::Node& fact = facts.nodes[root];
        if (!fact.empty && fact.material != SolidFacts::mixed && materials.all[fact.material].fills)
            of_material[fact.material].push_back(root);
    }
    Scene out = scene;
    for (const auto& [material, roots] : of_material) {
        std::vector<std::uint32_t> touching;
        for (const std::uint32_t root : roots)
            for (const std::uint32_t other : roots)
                if (root != other && facts.boxes[root].overlaps(facts.boxes[other])) {
                    touching.push_back(root);
                    break;
                }
        if (touching.empty()) continue;
        std::erase_if(out.solids.roots, [&](std::uint32_t root) {
            return std::find(touching.begin(), touching.end(), root) != touching.end();
        });
        out.solids.roots.push_back(out.solids.add_node(SolidOp::unite, touching));
    }
    return out;
}

}  // namespace

std::string write_solids(const Scene& scene, const SolidSettings& settings, Notes& notes) {
    const Scene merged = with_glass_merged(scene, settings.materials);
    return SolidWriter(merged, settings, notes).run();
}

}  // namespace cardioid::formats::povray
