#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "formats/figure/figure_file.hpp"
#include "formats/figure/join_lines.hpp"

namespace cardioid::formats {

/// One entity of a DXF as its groups come.
struct DxfEntity {
    std::string type, layer, name;

    DxfEntity() = default;
    DxfEntity(std::string_view of_type, std::size_t at_line) : type(of_type), line_(at_line) {}

    void set(std::int64_t code, std::string_view value);
    /// The last number of a group code.
    [[nodiscard]] double number(int code, double fallback) const;
    /// Point i of those in groups 10 and 11, in the drawing's units or (top level) as the options want it.
    [[nodiscard]] Vec2d point(std::size_t i, const FigureOptions& options, bool top_level) const;
    /// Its lines; false where this is nothing that can be drawn.
    bool draw(const FigureOptions& options, bool top_level, std::vector<Line>& out) const;

private:
    void polyline(const FigureOptions& options, bool top_level, std::vector<Line>& out) const;
    void arc(double from_deg, double to_deg, const FigureOptions& options, bool top_level,
             std::vector<Line>& out) const;
    void ellipse(const FigureOptions& options, bool top_level, std::vector<Line>& out) const;

    std::size_t line_ = 0;
    std::vector<double> xs_, ys_;
    std::vector<std::pair<int, double>> numbers_;
};

}  // namespace cardioid::formats
