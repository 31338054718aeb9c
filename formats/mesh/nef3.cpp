#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "csg/shapes/triangulate.hpp"
#include "formats/mesh/readers.hpp"
#include "formats/mesh/text_cursor.hpp"

namespace cardioid::formats {

namespace {

/// What a line "7 { 1, 2 3, 4 | 0 0 1 1 } 1" holds: the words between the commas, those behind the bar, and the mark.
struct Item {
    std::vector<std::vector<std::string_view>> fields;
    std::vector<std::string_view> numbers;
    bool mark = false;
};

/// CGAL's text of a Nef polyhedron: points with the lines, planes and volumes around them. Of those this takes the
/// facets between what is within and what is not.
class Nef3 {
public:
    Nef3(const MeshText& text, MeshBuilder& mesh) : in_(text.bytes, text.file), mesh_(mesh) {}

    void read() {
        expect("Selective");
        expect("Nef");
        expect("Complex");
        expect("standard");  // "extended" ones are cut off by a box of no particular size
        const std::size_t vertices = count("vertices"), lines = count("halfedges"), facets = count("facets");
        const std::size_t volumes = count("volumes"), sides = count("shalfedges");
        count("shalfloops");
        count("sfaces");
        for (std::size_t i = 0; i < vertices; ++i) add_vertex(item());
        for (std::size_t i = 0; i < lines; ++i) source_.push_back(index(item(), 1, vertices, "a vertex's number"));
        for (std::size_t i = 0; i < facets; ++i) facets_.push_back(item());
        for (std::size_t i = 0; i < volumes; ++i) inside_.push_back(item().mark);
        for (std::size_t i = 0; i < sides; ++i) {
            const Item side = item();
            corner_.push_back(source_[index(side, 3, lines, "a halfedge's number")]);
            next_.push_back(index(side, 6, sides, "a shalfedge's number"));
        }
        for (const Item& facet : facets_) add_facet(facet);
    }

private:
    void expect(std::string_view wanted) {
        if (const std::string_view found = in_.word(); found != wanted) in_.fail(found, quoted(wanted));
    }

    std::size_t count(std::string_view name) {
        expect(name);
        const std::int64_t n = in_.integer(in_.word(), "a number of " + std::string(name));
        if (n < 0) in_.fail(std::to_string(n), "a number of " + std::string(name));
        return static_cast<std::size_t>(n);
    }

    /// A whole number or a quotient of two.
    [[nodiscard]] double number(std::string_view word) const {
        const std::size_t slash = word.find('/');
        if (slash == std::string_view::npos) return in_.number(word, "a coordinate");
        const double over = in_.number(word.substr(slash + 1), "a coordinate");
        if (over == 0) in_.fail(word, "a coordinate");
        return in_.number(word.substr(0, slash), "a coordinate") / over;
    }

    /// A word of the line; a comma is one by itself.
    std::string_view next_word() {
        if (rest_.empty()) rest_ = in_.word_in_line();
        const std::size_t comma = rest_.find(',');
        const std::size_t length = comma == 0 ? 1 : std::min(comma, rest_.size());
        const std::string_view out = rest_.substr(0, length);
        rest_.remove_prefix(length);
        return out;
    }

    Item item() {
        Item out{{{}}, {}, false};
        static_cast<void>(in_.integer(in_.word(), "an item's number"));
        if (const std::string_view brace = next_word(); brace != "{") in_.fail(brace, "{");
        bool behind_bar = false;
        for (std::string_view word = next_word(); word != "}"; word = next_word()) {
            if (word.empty()) in_.fail(word, "}");
            if (word == "|")
                behind_bar = true;
            else if (behind_bar)
                static_cast<void>(number(word)), out.numbers.push_back(word);
            else if (word == ",")
                out.fields.emplace_back();
            else
                static_cast<void>(in_.integer(word, "a number")), out.fields.back().push_back(word);
        }
        const std::string_view mark = next_word();
        if (mark != "0" && mark != "1") in_.fail(mark, "a mark, 0 or 1");
        out.mark = mark == "1";
        return out;
    }

    /// The number that stands alone in a field.
    [[nodiscard]] std::size_t index(const Item& from, std::size_t field, std::size_t below, const char* wanted) const {
        if (field >= from.fields.size() || from.fields[field].size() != 1) in_.fail("", wanted);
        return index(from.fields[field][0], below, wanted);
    }

    [[nodiscard]] std::size_t index(std::string_view word, std::size_t below, const char* wanted) const {
        const std::int64_t i = in_.integer(word, wanted);
        if (i < 0 || static_cast<std::uint64_t>(i) >= below) in_.fail(word, wanted);
        return static_cast<std::size_t>(i);
    }

    void add_vertex(const Item& vertex) {
        if (vertex.numbers.size() != 4) in_.fail("", "four coordinates of a point");
        std::array<double, 4> x{};
        for (std::size_t i = 0; i < 4; ++i) x[i] = number(vertex.numbers[i]);
        const Vec3d p = Vec3d{x[0], x[1], x[2]} / x[3];
        if (x[3] == 0 || !is_finite(p)) in_.fail(vertex.numbers[3], "a point that is not at infinity");
        points_.push_back(p);
        mesh_.add_vertex(p);
    }

    /// The corners of a closed chain of sides.
    [[nodiscard]] std::vector<std::uint32_t> cycle(std::size_t first) const {
        std::vector<std::uint32_t> out;
        std::size_t side = first;
        do {
            out.push_back(static_cast<std::uint32_t>(corner_[side]));
            side = next_[side];
        } while (side != first && out.size() <= next_.size());
        if (side != first) in_.fail("", "shalfedges in closed chains");
        return out;
    }

    /// Facets come in pairs, one seen from each side; wanted is the one from outside, around which its cycles run
    /// counter-clockwise.
    void add_facet(const Item& facet) {
        const Item& twin = facets_[index(facet, 0, facets_.size(), "a facet's number")];
        const auto within = [&](const Item& side) {
            return inside_[index(side, 3, inside_.size(), "a volume's number")];
        };
        if (within(facet) || !within(twin)) return;
        std::vector<std::vector<std::uint32_t>> cycles;
        for (const std::string_view word : facet.fields[1])
            cycles.push_back(cycle(index(word, next_.size(), "a shalfedge's number")));
        if (cycles.size() == 1)
            mesh_.add_face(cycles[0]);
        else
            add_holed(cycles);
    }

    void add_holed(const std::vector<std::vector<std::uint32_t>>& cycles) {
        Vec3d normal;
        std::vector<std::uint32_t> numbers;
        for (const auto& corners : cycles)
            for (std::size_t i = 0; i < corners.size(); ++i) {
                normal += cross(points_[corners[i]], points_[corners[(i + 1) % corners.size()]]);
                numbers.push_back(corners[i]);
            }
        const Vec3d size = abs(normal);
        const int away = size.x > std::max(size.y, size.z) ? 0
                         : size.y > size.z                 ? 1
                                                           : 2,
                  u = (away + 1) % 3, v = (away + 2) % 3;
        Profile flat;
        for (const auto& corners : cycles) {
            auto& contour = flat.contours.emplace_back();
            for (const std::uint32_t c : corners) contour.push_back({points_[c][u], points_[c][v]});
        }
        for (const auto& [a, b, c] : csg::fill(flat).triangles) {
            if (std::max({a, b, c}) >= numbers.size()) in_.fail("", "facets whose edges do not cross");
            std::array<std::uint32_t, 3> face{numbers[a], numbers[b], numbers[c]};
            if (normal[away] < 0) std::swap(face[1], face[2]);
            mesh_.add_face(face);
        }
    }

    TextCursor in_;
    MeshBuilder& mesh_;
    std::string_view rest_;  ///< of a word that holds commas
    std::vector<Vec3d> points_;
    std::vector<std::size_t> source_;         ///< of each halfedge: its vertex
    std::vector<std::size_t> corner_, next_;  ///< of each shalfedge: its vertex, the next around its facet
    std::vector<Item> facets_;
    std::vector<bool> inside_;  ///< of each volume
};

}  // namespace

void read_nef3(const MeshText& text, MeshBuilder& mesh) { Nef3(text, mesh).read(); }

}  // namespace cardioid::formats
