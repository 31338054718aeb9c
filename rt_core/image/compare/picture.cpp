#include "rt_core/image/compare/picture.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "rt_core/api/error.hpp"
#include "rt_core/image/encode.hpp"
#include "rt_core/image/image_file.hpp"

namespace cardioid {

namespace {

/// The picture among the layers: the one without a name, else the first (a file of one layer may name it).
std::size_t picture_layer(const Film& film) {
    for (std::size_t i = 0; i < film.layers.size(); ++i)
        if (film.layers[i].name.empty()) return i;
    return 0;
}

}  // namespace

Picture read_picture(const std::string& path) {
    bool encoded = false;
    Film film = read_image(path, nullptr, &encoded);
    Picture out{path, film.width, film.height, 0, encoded, {}, {}, {}};
    if (film.layers.empty()) throw Error(ErrorCode::bad_input, path + ": found no channels, wanted a picture");
    const auto at = film.layers.begin() + static_cast<std::ptrdiff_t>(picture_layer(film));
    const Layer picture = std::move(*at);
    film.layers.erase(at);
    out.layers = std::move(film.layers);
    out.channels = picture.channels;
    if (picture.channels < 1 || picture.channels > 4)
        throw Error(ErrorCode::bad_input, fmt::format("{}: found {} channels, wanted 1 to 4", path, picture.channels));
    const auto width = static_cast<std::size_t>(picture.channels);
    const bool colour = width >= 3, alpha = width % 2 == 0;
    const std::size_t n = picture.pixels.size() / width;
    const auto light = [&](float x) { return encoded ? srgb_decode(x) : x; };
    out.pixels.reserve(n);
    for (std::size_t i = 0; i < n; ++i) {
        const float* p = picture.pixels.data() + i * width;
        out.pixels.push_back(colour ? Rgb{light(p[0]), light(p[1]), light(p[2])} : Rgb(light(p[0])));
        if (alpha) out.alpha.push_back(p[width - 1]);
    }
    return out;
}

}  // namespace cardioid
