#include "formats/openscad/geometry/surface.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "formats/mesh/mesh_file.hpp"
#include "formats/mesh/text_cursor.hpp"
#include "formats/openscad/geometry/plane_files.hpp"
#include "rt_core/image/image_file.hpp"

namespace cardioid::formats::openscad {
namespace {

/// Heights on a grid of one unit, row by row from y = 0.
struct HeightMap {
    std::size_t columns = 0, rows = 0;
    std::vector<double> heights;
    double floor = 0;  ///< 1 below what was given, at most 0: heights that were filled up do not lower it
    [[nodiscard]] double at(std::size_t x, std::size_t y) const { return heights[y * columns + x]; }
};

/// Corners and middles of cells are numbered by 32 bits.
constexpr double most_numbers = 2e9;

/// Four triangles a cell fill memory.
void check_size(double columns, double rows, double most_cells, const std::string& path) {
    const double most = std::min(most_cells, most_numbers);
    if (columns * rows > most)
        throw Error(ErrorCode::limit,
                    fmt::format("{}: found a height map of {:.0f} cells or more, wanted at most {:.0f}{}", path,
                                columns * rows, most,
                                most < most_numbers ? fmt::format(": fewer, or --set csg.cells={:.0f}", columns * rows)
                                                    : std::string()));
}

/// Rows of numbers; '#' begins a comment; short rows are filled up with 0.
HeightMap read_numbers(const std::string& path, double most_cells) {
    const std::string bytes = read_bytes(path);
    TextCursor in(bytes, path);
    std::vector<std::vector<double>> rows;
    HeightMap out;
    for (; !in.at_end(); in.skip_line()) {
        std::vector<double> row;
        for (std::string_view word = in.word_in_line(); !word.empty() && word[0] != '#'; word = in.word_in_line())
            out.floor = std::min(out.floor, row.emplace_back(in.number(word, "a height")) - 1);
        if (row.empty()) continue;
        out.columns = std::max(out.columns, row.size());
        rows.push_back(std::move(row));
        check_size(static_cast<double>(out.columns), static_cast<double>(rows.size()), most_cells, path);
    }
    out.rows = rows.size();
    for (std::vector<double>& row : rows) {
        row.resize(out.columns);
        out.heights.insert(out.heights.end(), row.begin(), row.end());
    }
    return out;
}

/// Brightness as heights from 0 to 100, the last row at y = 0.
HeightMap read_picture(const std::string& path, bool invert, double most_cells) {
    const Film film = read_image(path);
    if (film.layers.empty()) throw Error(ErrorCode::bad_input, path + ": found a picture without channels");
    const Layer& layer = film.layers[0];
    HeightMap out{static_cast<std::size_t>(film.width), static_cast<std::size_t>(film.height), {}};
    check_size(film.width, film.height, most_cells, path);
    out.heights.resize(out.columns * out.rows);
    const auto channels = static_cast<std::size_t>(layer.channels);
    constexpr double share[] = {0.2126, 0.7152, 0.0722};  // of red, green and blue in what the eye sees (Rec. 709)
    for (std::size_t y = 0; y < out.rows; ++y)
        for (std::size_t x = 0; x < out.columns; ++x) {
            const float* const pixel = &layer.pixels[((out.rows - 1 - y) * out.columns + x) * channels];
            double brightness = 0;
            for (std::size_t c = 0; c < 3; ++c) brightness += share[c] * double(pixel[channels < 3 ? 0 : c]);
            // OpenSCAD 2021.01 inverts about one step of 255, not about white.
            const double height = 100 * (invert ? 1.0 / 255 - brightness : brightness);
            out.heights[y * out.columns + x] = height;
            out.floor = std::min(out.floor, height - 1);
        }
    return out;
}

/// The map as a solid: each cell four triangles about its middle, walls down to a flat floor.
class Relief {
public:
    Relief(const HeightMap& map, bool centre) : map_(map) {
        if (centre) middle_ = {static_cast<double>(map.columns - 1) / -2, static_cast<double>(map.rows - 1) / -2};
    }

    TriangleMesh make() {
        const std::size_t n = map_.columns, m = map_.rows;
        for (std::size_t y = 0; y < m; ++y)
            for (std::size_t x = 0; x < n; ++x) add(double(x), double(y), map_.at(x, y));
        for (std::size_t y = 0; y + 1 < m; ++y)
            for (std::size_t x = 0; x + 1 < n; ++x) cell(x, y);
        for (std::size_t x = 0; x + 1 < n; ++x) wall(x, 0, x + 1, 0), wall(x + 1, m - 1, x, m - 1);
        for (std::size_t y = 0; y + 1 < m; ++y) wall(n - 1, y, n - 1, y + 1), wall(0, y + 1, 0, y);
        const std::uint32_t last = add(double(n - 1) / 2, double(m - 1) / 2, map_.floor);
        for (const auto& [a, b] : rim_) mesh_.triangles.push_back({last, b, a});
        return std::move(mesh_);
    }

private:
    std::uint32_t add(double x, double y, double z) {
        mesh_.vertices.push_back({x + middle_.x, y + middle_.y, z});
        return static_cast<std::uint32_t>(mesh_.vertices.size() - 1);
    }
    [[nodiscard]] std::uint32_t corner(std::size_t x, std::size_t y) const {
        return static_cast<std::uint32_t>(y * map_.columns + x);
    }
    void cell(std::size_t x, std::size_t y) {
        const std::uint32_t ring[] = {corner(x, y), corner(x + 1, y), corner(x + 1, y + 1), corner(x, y + 1)};
        double mean = 0;
        for (const std::uint32_t v : ring) mean += map_.heights[v] / 4;
        const std::uint32_t middle = add(double(x) + 0.5, double(y) + 0.5, mean);
        for (std::size_t i = 0; i < 4; ++i) mesh_.triangles.push_back({middle, ring[i], ring[(i + 1) % 4]});
    }
    /// A wall under the edge between two corners, seen from outside with the first on the left.
    void wall(std::size_t ax, std::size_t ay, std::size_t bx, std::size_t by) {
        const std::uint32_t a = corner(ax, ay), b = corner(bx, by);
        const std::uint32_t c = add(double(ax), double(ay), map_.floor), d = add(double(bx), double(by), map_.floor);
        mesh_.triangles.push_back({a, c, d});
        mesh_.triangles.push_back({a, d, b});
        rim_.emplace_back(c, d);
    }

    const HeightMap& map_;
    Vec2d middle_;
    TriangleMesh mesh_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> rim_;
};

}  // namespace

std::optional<Shape> make_surface(const Arguments& args, ShapeContext& context) {
    const std::string name = args.text("file");
    if (name.empty()) {
        context.warnings.add(args.where(), "found no file name, wanted surface(file = \"heights.dat\"): removed");
        return std::nullopt;
    }
    HeightMap map;
    try {
        const std::string path = path_of(name, context);
        map = lower_extension(name) == ".png" ? read_picture(path, args.boolean("invert", false), context.limits.cells)
                                              : read_numbers(path, context.limits.cells);
    } catch (const Error& e) {
        pass_over(e, args, context);
        return std::nullopt;
    }
    if (map.columns < 2 || map.rows < 2) {
        context.warnings.add(args.where(), "surface() has fewer than two rows or columns: removed");
        return std::nullopt;
    }
    return make_mesh(Relief(map, args.boolean("center", false)).make(), args.where(), context);
}

}  // namespace cardioid::formats::openscad
