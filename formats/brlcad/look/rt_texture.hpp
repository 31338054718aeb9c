#pragma once
#include <string>
#include <vector>

#include "rt_core/api/math.hpp"

namespace cardioid::formats::brlcad {

/// Colours over surface coordinates, 0 to 1 as a display has them: sh_text.c and sh_cloud.c.
class RtTexture {
public:
    enum class Kind { none, checker, cloud, testmap, image };
    Kind kind = Kind::none;
    Rgb a{1}, b{0};                        ///< of a checker
    double scale = 2;                      ///< fields of a checker across
    double threshold = 0.35, range = 0.3;  ///< of a cloud: where it begins and how fast it is thick
    std::size_t width = 0, height = 0;     ///< of an image [pixels]
    double repeat_u = 1, repeat_v = 1;     ///< of an image
    std::vector<unsigned char> pixels;     ///< of an image: red, green, blue, the lowest row first

    [[nodiscard]] Rgb at(Vec2d uv) const noexcept;
    /// Reads an image's pixels, `width` by `height` of them, as a .pix file has them; false where it cannot be read or
    /// has too few.
    [[nodiscard]] bool load(const std::string& path);

private:
    [[nodiscard]] Rgb pixel(Vec2d uv) const noexcept;
};

}  // namespace cardioid::formats::brlcad
