#include "rt_core/render/tiles.hpp"

#include <algorithm>
#include <cstdint>

namespace cardioid {

namespace {

/// Spreads the bits of x so that a free bit lies above each.
std::uint64_t spread(std::uint32_t x) {
    std::uint64_t out = 0;
    for (unsigned bit = 0; bit < 32; ++bit) out |= static_cast<std::uint64_t>(x >> bit & 1) << (2 * bit);
    return out;
}

std::uint64_t morton(const Tile& tile, const std::array<int, 4>& crop) {
    const auto column = static_cast<std::uint32_t>((tile.x0 - crop[0]) / tile_size);
    const auto row = static_cast<std::uint32_t>((tile.y0 - crop[1]) / tile_size);
    return spread(column) | spread(row) << 1;
}

}  // namespace

std::vector<Tile> morton_tiles(const std::array<int, 4>& crop) {
    std::vector<Tile> tiles;
    for (int y = crop[1]; y < crop[3]; y += tile_size)
        for (int x = crop[0]; x < crop[2]; x += tile_size)
            tiles.push_back({x, y, std::min(x + tile_size, crop[2]), std::min(y + tile_size, crop[3])});
    std::sort(tiles.begin(), tiles.end(),
              [&](const Tile& a, const Tile& b) { return morton(a, crop) < morton(b, crop); });
    return tiles;
}

}  // namespace cardioid
