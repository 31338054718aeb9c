#pragma once
#include <array>
#include <vector>

namespace cardioid {

/// Edge of a tile, pixels.
inline constexpr int tile_size = 16;

/// Pixels [x0, x1) x [y0, y1) of the picture.
struct Tile {
    int x0, y0, x1, y1;
};

/// Tiles that cover crop (x0, y0, x1, y1), along Morton's curve so that neighbours in time are neighbours in space.
std::vector<Tile> morton_tiles(const std::array<int, 4>& crop);

}  // namespace cardioid
