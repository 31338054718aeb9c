#include "formats/figure/join_lines.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <map>

namespace cardioid::formats {
namespace {

constexpr double grid = 0x1p-20;

/// Numbers the ends: those within a step of the grid are one.
class Ends {
public:
    std::size_t number(Vec2d p) {
        const auto x = step(p.x), y = step(p.y);
        for (std::int64_t i = -1; i <= 1; ++i)
            for (std::int64_t j = -1; j <= 1; ++j)
                if (const auto at = numbers_.find({x + i, y + j}); at != numbers_.end()) return at->second;
        points.push_back(p);
        return numbers_[{x, y}] = points.size() - 1;
    }
    std::vector<Vec2d> points;

private:
    /// Beyond 2^42 all are the same: such drawings are damaged.
    static std::int64_t step(double x) {
        return static_cast<std::int64_t>(std::llround(std::fmin(std::fmax(x / grid, -0x1p62), 0x1p62)));
    }
    std::map<std::pair<std::int64_t, std::int64_t>, std::size_t> numbers_;
};

class Joiner {
public:
    explicit Joiner(const std::vector<Line>& lines) {
        for (const Line& line : lines) {
            const std::size_t a = ends_.number(line.a), b = ends_.number(line.b);
            if (a != b) ends_of_.push_back({a, b});
        }
        lines_at_.resize(ends_.points.size());
        for (std::size_t i = 0; i < ends_of_.size(); ++i)
            for (const std::size_t end : ends_of_[i]) lines_at_[end].push_back(i);
        used_.resize(ends_of_.size());
    }

    std::vector<std::vector<Vec2d>> run() {
        for (std::size_t i = 0; i < ends_of_.size(); ++i)
            for (const std::size_t end : ends_of_[i])
                if (!used_[i] && lines_at_[end].size() == 1) follow(i, end);
        for (std::size_t i = 0; i < ends_of_.size(); ++i)
            if (!used_[i]) follow(i, ends_of_[i][0]);
        return std::move(out_);
    }

private:
    void follow(std::size_t line, std::size_t from) {
        std::vector<Vec2d> chain{ends_.points[from]};
        const std::size_t start = from;
        for (bool more = true; more;) {
            used_[line] = true;
            from = ends_of_[line][0] == from ? ends_of_[line][1] : ends_of_[line][0];
            if (from != start) chain.push_back(ends_.points[from]);
            more = false;
            for (const std::size_t next : lines_at_[from])
                if (!used_[next]) {
                    line = next;
                    more = true;
                    break;
                }
        }
        if (chain.size() >= 3) out_.push_back(std::move(chain));
    }

    Ends ends_;
    std::vector<std::array<std::size_t, 2>> ends_of_;
    std::vector<std::vector<std::size_t>> lines_at_;
    std::vector<bool> used_;
    std::vector<std::vector<Vec2d>> out_;
};

}  // namespace

std::vector<std::vector<Vec2d>> join_lines(const std::vector<Line>& lines) { return Joiner(lines).run(); }

}  // namespace cardioid::formats
