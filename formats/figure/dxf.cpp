#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "formats/figure/dxf_entity.hpp"
#include "formats/figure/figure_file.hpp"
#include "formats/figure/join_lines.hpp"
#include "formats/mesh/text_cursor.hpp"
#include "rt_core/api/error.hpp"

namespace cardioid::formats {
namespace {

/// Reads a DXF as OpenSCAD 2021.01 does: lines, polylines (bulges drawn straight), circles, arcs, ellipses and inserted
/// blocks; ends that meet are joined, and what stays open is closed.
class DxfReader {
public:
    DxfReader(std::string_view text, std::string file, const FigureOptions& options)
        : in_(text, file), file_(std::move(file)), options_(options) {}

    FigureFile read() {
        DxfEntity entity;
        while (next_pair()) {
            if (code_ != 0) {
                entity.set(code_, value_);
                continue;
            }
            finish(entity);
            entity = DxfEntity(value_, in_.line());
        }
        finish(entity);
        report();
        FigureFile out;
        out.warnings = std::move(warnings_);
        Profile figure{join_lines(lines_)};
        if (!figure.empty()) out.figures.push_back(std::move(figure));
        return out;
    }

private:
    /// A group: its code on one line, its value on the next.
    bool next_pair() {
        std::string_view code = in_.rest().substr(0, in_.rest().find('\n'));
        in_.skip_line();
        const std::size_t first = code.find_first_not_of(" \t\r");
        if (first == std::string_view::npos) return in_.at_end() ? false : (code_ = 999, in_.skip_line(), true);
        code = code.substr(first, code.find_last_not_of(" \t\r") - first + 1);
        code_ = in_.integer(code, "a group code");
        value_ = in_.rest().substr(0, in_.rest().find('\n'));
        in_.skip_line();
        const std::size_t end = value_.find_last_not_of(" \t\r");
        value_ = value_.substr(0, end == std::string_view::npos ? 0 : end + 1);
        value_.remove_prefix(std::min(value_.find_first_not_of(" \t"), value_.size()));
        return true;
    }

    void finish(const DxfEntity& entity) {
        if (entity.type == "SECTION") section_ = entity.name;
        if (entity.type == "BLOCK") block_ = entity.name;
        if (entity.type == "ENDBLK") block_.clear();
        if (section_ != "ENTITIES" && section_ != "BLOCKS") return;
        if (section_ == "BLOCKS") {
            if (!block_.empty()) draw(entity, blocks_[block_]);
        } else if (options_.layer.empty() || entity.layer == options_.layer) {
            draw(entity, lines_);
        }
    }

    void draw(const DxfEntity& entity, std::vector<Line>& out) {
        static constexpr std::string_view silent[] = {"",    "SECTION",   "ENDSEC",   "BLOCK", "ENDBLK",
                                                      "EOF", "DIMENSION", "VIEWPORT", "SEQEND"};
        const std::string& type = entity.type;
        if (type == "INSERT") return insert(entity, out);
        if (entity.draw(options_, section_ == "ENTITIES", out)) return;
        if (std::ranges::find(silent, type) == std::end(silent)) ++unknown_[type];
    }

    /// A block's lines, scaled, turned and moved.
    void insert(const DxfEntity& entity, std::vector<Line>& out) {
        const auto block = blocks_.find(entity.name);
        if (block == blocks_.end()) return;
        const double turn = entity.number(50, 0) * (std::numbers::pi / 180), c = std::cos(turn), s = std::sin(turn);
        const double sx = entity.number(41, 1), sy = entity.number(42, 1);
        const double scale = section_ == "ENTITIES" ? options_.scale : 1;
        const Vec2d to = entity.point(0, options_, section_ == "ENTITIES");
        const auto placed = [&](Vec2d p) {
            return Vec2d{c * p.x * sx - s * p.y * sy, s * p.x * sx + c * p.y * sy} * scale + to;
        };
        constexpr std::size_t most_lines = 10'000'000;
        const std::vector<Line> lines = block->second;  // a block may insert itself, again and again
        if (out.size() + lines.size() > most_lines)
            throw Error(ErrorCode::limit, file_ + ": found blocks that make more than ten million lines");
        for (const Line& line : lines) out.push_back({placed(line.a), placed(line.b)});
    }

    void report() {
        for (const auto& [type, count] : unknown_)
            warnings_.push_back(file_ + ": " + std::to_string(count) + " entities " + quoted(type) + " are left out");
    }

    TextCursor in_;
    std::string file_;
    const FigureOptions& options_;
    std::int64_t code_ = 0;
    std::string_view value_;
    std::string section_, block_;
    std::vector<Line> lines_;
    std::map<std::string, std::vector<Line>> blocks_;
    std::map<std::string, int> unknown_;
    std::vector<std::string> warnings_;
};

}  // namespace

FigureFile read_dxf(std::string_view text, const std::string& file, const FigureOptions& options) {
    return DxfReader(text, file, options).read();
}

}  // namespace cardioid::formats
