#pragma once
#include <string>
#include <vector>

namespace cardioid::test {

/// CGAL's text of a solid whose facets are chains of corners, counter-clockwise seen from outside.
inline std::string nef3(const std::vector<std::string>& points,
                        const std::vector<std::vector<std::vector<int>>>& facets) {
    std::string lines, planes, sides;
    std::size_t side = 0;
    for (std::size_t f = 0; f < facets.size(); ++f) {
        std::string firsts;
        for (const std::vector<int>& chain : facets[f]) {
            firsts += std::to_string(side) + " ";
            const std::size_t first = side;
            for (std::size_t i = 0; i < chain.size(); ++i, ++side) {
                const std::string n = std::to_string(side);
                const std::size_t next = i + 1 < chain.size() ? side + 1 : first;
                lines += n + " { 0, " + std::to_string(chain[i]) + ", 0 0 | 0 -1 0 1 } 1\n";
                sides += n + " { 0, 0, 0, " + n + ", 0, 0, " + std::to_string(next) + ", 0 | 1 0 0 0 } 1\n";
            }
        }
        const std::string seen = std::to_string(2 * f), behind = std::to_string(2 * f + 1);
        planes += seen + " { " + behind + ", " + firsts + ", , 0 | 1 0 0 -1 } 1\n";
        planes += behind + " { " + seen + ", , , 1 | -1 0 0 1 } 1\n";
    }
    std::string out = "Selective Nef Complex\nstandard\nvertices   " + std::to_string(points.size()) + "\nhalfedges  " +
                      std::to_string(side) + "\nfacets " + std::to_string(2 * facets.size()) +
                      "\nvolumes 2\nshalfedges " + std::to_string(side) + "\nshalfloops 0\nsfaces 0\n";
    for (std::size_t i = 0; i < points.size(); ++i)
        out += std::to_string(i) + " { 0 2, 0 5, 0 1, -2 | " + points[i] + " } 1\n";
    return out + lines + planes + "0 { 0 } 0\n1 { 1 } 1\n" + sides + "/* end Selective Nef complex */\n";
}

/// A block of 3 x 3 x 1 with a hole of 1 x 1 through it, its coordinates thirds and homogeneous.
inline std::string nef3_frame() {
    std::vector<std::string> points;
    for (const char* z : {"0", "7"})
        for (const char* xy : {"0 0", "21 0", "21 21", "0 21", "7 7", "14 7", "14 14", "42/3 7"})
            points.push_back(std::string(xy) + " " + z + " 7");
    points[7] = "7 42/3 0 7", points[15] = "7 42/3 7 7";
    std::vector<std::vector<std::vector<int>>> facets{{{8, 9, 10, 11}, {12, 15, 14, 13}}, {{3, 2, 1, 0}, {4, 5, 6, 7}}};
    for (int i = 0; i < 4; ++i) {
        const int j = (i + 1) % 4;
        facets.push_back({{i, j, j + 8, i + 8}});
        facets.push_back({{j + 4, i + 4, i + 12, j + 12}});
    }
    return nef3(points, facets);
}

}  // namespace cardioid::test
