#include "rt_core/image/compare/edges.hpp"

#include <algorithm>
#include <cmath>

namespace cardioid {

namespace {

/// Neighbours whose normals differ by more than some 20 degrees lie on different sides; whose depths differ by more
/// than this share, on different surfaces.
constexpr float least_cosine = 0.94F, most_depth = 0.1F;

struct Layers {
    const Layer *region, *normal, *depth;

    [[nodiscard]] bool apart(std::size_t i, std::size_t j) const {
        if (region && region->pixels[i] != region->pixels[j]) return true;
        if (normal && normal->channels == 3) {
            const float* a = normal->pixels.data() + 3 * i;
            const float* b = normal->pixels.data() + 3 * j;
            const float ab = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
            const float aa = a[0] * a[0] + a[1] * a[1] + a[2] * a[2], bb = b[0] * b[0] + b[1] * b[1] + b[2] * b[2];
            if ((aa > 0) != (bb > 0) || ab < least_cosine * std::sqrt(aa * bb)) return true;
        }
        if (!depth) return false;
        const float a = depth->pixels[i], b = depth->pixels[j];
        return std::abs(a - b) > most_depth * std::max(a, b);
    }
};

}  // namespace

std::vector<bool> find_edges(const Picture& picture) {
    const Layers layers{picture.layer("region"), picture.layer("normal"), picture.layer("depth")};
    if (!layers.region && !layers.normal && !layers.depth) return {};
    const int width = picture.width, height = picture.height;
    const auto index = [&](int x, int y) {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    };
    std::vector<bool> edges(picture.pixels.size());
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int ny = std::max(0, y - 1); ny <= std::min(height - 1, y + 1); ++ny)
                for (int nx = std::max(0, x - 1); nx <= std::min(width - 1, x + 1); ++nx)
                    if (layers.apart(index(x, y), index(nx, ny))) edges[index(x, y)] = true;
    return edges;
}

}  // namespace cardioid
