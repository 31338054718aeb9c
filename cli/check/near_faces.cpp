#include <fmt/format.h>

#include "cli/check/find_faults.hpp"
#include "cli/commands/describe.hpp"
#include "csg/coincidence.hpp"

namespace cardioid::cli {
namespace {

/// What is thinner than this share of the model's size nobody meant: ten times what six digits tell. Databases have
/// all digits of a double, and gaps in them that are small and real.
constexpr double sliver_share = 1e-5, database_sliver_share = 1e-6;

std::string leaf_name(const Scene& scene, std::uint32_t index) {
    const Leaf& leaf = scene.solids.leaves[index];
    const std::string place = leaf.line > 0 ? fmt::format("{}:{}", scene.file, leaf.line) : scene.file;
    return fmt::format("{} ({})", place, leaf_kind_name(leaf.kind));
}

const char* kind_name(csg::NearFaces::Kind kind) {
    switch (kind) {
        case csg::NearFaces::Kind::coincident:
            return "coincident";
        case csg::NearFaces::Kind::thin_solid:
            return "thin_solid";
        case csg::NearFaces::Kind::thin_gap:
            return "thin_gap";
    }
    return "";
}

Finding describe(const Scene& scene, const csg::NearFaces& pair) {
    const std::string a = leaf_name(scene, pair.a), b = leaf_name(scene, pair.b);
    const std::string where = point_text(pair.where);
    Finding out{.kind = kind_name(pair.kind),
                .text = {},
                .at = pair.where,
                .depth = pair.distance,
                .volume = {},
                .between = {a, b}};
    switch (pair.kind) {
        case csg::NearFaces::Kind::coincident:
            out.text = fmt::format("{} and {} have a face in common at {}", a, b, where);
            if (pair.distance > 0) out.text += fmt::format(", up to {:.2g} apart", pair.distance);
            break;
        case csg::NearFaces::Kind::thin_solid:
            out.text =
                fmt::format("{} and {} leave a skin {:.2g} thick between them at {}", a, b, pair.distance, where);
            break;
        case csg::NearFaces::Kind::thin_gap:
            out.text = fmt::format("{} and {} leave a gap {:.2g} wide between them at {}", a, b, pair.distance, where);
            break;
    }
    return out;
}

}  // namespace

void find_near_faces(const Scene& scene, Findings& findings) {
    const csg::NearFaceReport report = csg::find_near_faces(scene.solids, scene.six_digits,
                                                            scene.names.empty() ? sliver_share : database_sliver_share);
    findings.face_grid = report.grid;
    for (const csg::NearFaces& pair : report.pairs)
        (pair.kind == csg::NearFaces::Kind::coincident ? findings.notes : findings.faults)
            .push_back(describe(scene, pair));
}

}  // namespace cardioid::cli
