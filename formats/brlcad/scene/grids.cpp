#include <bit>
#include <cmath>

#include "csg/shapes/grid_mesh.hpp"
#include "formats/brlcad/scene/grid_data.hpp"

namespace cardioid::formats::brlcad {

namespace {

using Node = std::optional<std::uint32_t>;

/// BRL-CAD's numbers of types of data.
constexpr int unsigned_8 = 4, unsigned_16 = 5, signed_8 = 12;
/// Of an ebm or vol.
constexpr std::size_t most_faces = 20'000'000;

unsigned byte_at(const std::string& bytes, std::size_t i) { return static_cast<unsigned char>(bytes[i]); }

Node add_placed(SolidTarget& target, const Affine& map, TriangleMesh mesh) {
    if (mesh.triangles.empty()) {
        target.note = "has no volume";
        return std::nullopt;
    }
    return add_leaf(target, {.kind = LeafKind::mesh, .to_world = map, .data = target.tree.add_mesh(std::move(mesh))});
}

Node add_dsp(SolidTarget& target, const Solid& solid) {
    GridFields fields(target, solid);
    const std::size_t w = fields.count("w"), n = fields.count("n");
    const Affine map = fields.map("stom");
    const bool old = solid.fields.contains("file");
    const std::string bytes =
        fields.bytes(old ? "file" : "name", !old && fields.text("src", "f") == "o", 2 * w * n, {unsigned_16});
    if (!fields.good()) return std::nullopt;
    std::vector<double> heights(w * n);
    for (std::size_t i = 0; i < heights.size(); ++i)
        heights[i] = static_cast<double>(byte_at(bytes, 2 * i) << 8 | byte_at(bytes, 2 * i + 1));
    const std::string cut = fields.text("cut", "a");
    return add_placed(target, map,
                      csg::height_mesh(heights, w,
                                       cut == "l"   ? csg::CellCut::rising
                                       : cut == "L" ? csg::CellCut::falling
                                                    : csg::CellCut::adaptive));
}

/// Boxes of cells, an ebm's of one layer: what a byte of the file says they are.
Node add_cells(SolidTarget& target, const Solid& solid) {
    GridFields fields(target, solid);
    const bool flat = solid.kind == SolidKind::ebm;
    const std::size_t w = fields.count("w"), n = fields.count("n"), d = flat ? 1 : fields.count("d");
    const std::vector<double> size =
        flat ? std::vector<double>{1, 1, fields.number("d", 0)} : fields.numbers("size", {1, 1, 1});
    const double least = flat ? 1 : fields.number("lo", 0), most = flat ? 255 : fields.number("hi", 255);
    const Affine map = fields.map("mat") * Affine::scaling({size[0], size[1], size[2]});
    const std::string bytes =
        fields.bytes(solid.fields.contains("file") ? "file" : "name", fields.text("src", "f") == "o",
                     std::uint64_t{w} * n * d, {unsigned_8, signed_8});
    if (!fields.good()) return std::nullopt;
    csg::CellMesh cells = csg::cell_mesh(
        w, n, d,
        [&](std::size_t x, std::size_t y, std::size_t z) {
            const unsigned value = byte_at(bytes, (z * n + y) * w + x);
            return value >= least && value <= most;
        },
        most_faces);
    if (cells.too_many) {
        target.note = "has more than twenty million faces, and is left out";
        return std::nullopt;
    }
    return add_placed(target, map, std::move(cells.mesh));
}

/// How an hf's numbers are written, as cv(1) says it: h or n for little or big end, s or u for a sign, and c, s, i, l,
/// d for bytes, words of 2, 4 and 8 bytes and doubles.
struct NumberFormat {
    bool big = false, is_signed = false;
    char kind = 'd';
    std::size_t size = 8;
};
std::optional<NumberFormat> number_format(const std::string& text) {
    static constexpr std::string_view kinds = "csild";
    static constexpr std::size_t sizes[] = {1, 2, 4, 8, 8};
    const std::size_t kind = text.empty() ? std::string_view::npos : kinds.find(text.back());
    if (kind == std::string_view::npos) return std::nullopt;
    return NumberFormat{text[0] == 'n', text.find('u') == std::string::npos, text.back(), sizes[kind]};
}

double number_at(const std::string& bytes, std::size_t i, const NumberFormat& format) {
    std::uint64_t bits = 0;
    for (std::size_t k = 0; k < format.size; ++k)
        bits = bits << 8 | byte_at(bytes, i * format.size + (format.big ? k : format.size - 1 - k));
    if (format.kind == 'd') return std::bit_cast<double>(bits);
    const auto shift = static_cast<int>(64 - 8 * format.size);
    return format.is_signed ? static_cast<double>(static_cast<std::int64_t>(bits << shift) >> shift)
                            : static_cast<double>(bits);
}

/// An older kind of height field, placed by its own axes. A file that controls it is not read.
Node add_hf(SolidTarget& target, const Solid& solid) {
    GridFields fields(target, solid);
    const std::size_t w = fields.count("w"), n = fields.count("n");
    const auto vector = [&](const char* key, std::vector<double> fallback) {
        const std::vector<double> v = fields.numbers(key, std::move(fallback));
        return Vec3d{v[0], v[1], v[2]};
    };
    const Vec3d v = vector("v", {0, 0, 0}), x = vector("x", {1, 0, 0}), y = vector("y", {0, 1, 0});
    const double xlen = fields.number("xlen", 1000), ylen = fields.number("ylen", 1000);
    const double unit = fields.number("file2mm", 1) * fields.number("zscale", 1);
    const auto format = number_format(fields.text("fmt", "nd"));
    if (fields.good() && (!format || w < 2 || n < 2 || !(length(x) > 0 && length(y) > 0))) {
        target.note = format ? "has no volume" : "has numbers of a form that is not known, and is left out";
        return std::nullopt;
    }
    const std::string bytes = fields.bytes("dfile", false, format ? std::uint64_t{w} * n * format->size : 0, {});
    if (!fields.good()) return std::nullopt;
    std::vector<double> heights(w * n);
    for (std::size_t i = 0; i < heights.size(); ++i) {
        const double height = number_at(bytes, i, *format);
        heights[i] = std::isfinite(height) && height > 0 ? height : 0;
    }
    const Vec3d along = x * (1 / length(x)), across = y * (1 / length(y)), up = cross(along, across);
    return add_placed(target,
                      columns(along * (xlen / static_cast<double>(w - 1)), across * (ylen / static_cast<double>(n - 1)),
                              up * unit, v),
                      csg::height_mesh(heights, w, csg::CellCut::rising));
}

}  // namespace

std::optional<std::uint32_t> add_grid(SolidTarget& target, const Solid& solid) {
    if (solid.kind == SolidKind::dsp) return add_dsp(target, solid);
    return solid.kind == SolidKind::hf ? add_hf(target, solid) : add_cells(target, solid);
}

}  // namespace cardioid::formats::brlcad
