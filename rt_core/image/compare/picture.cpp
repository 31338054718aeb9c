#include "rt_core/image/compare/picture.hpp"

#include <OpenImageIO/imageio.h>
#include <algorithm>
#include <fmt/format.h>

#include "rt_core/api/error.hpp"
#include "rt_core/image/encode.hpp"
#include "rt_core/image/image_file.hpp"

namespace cardioid {

namespace {

/// Whole numbers are what a display is given, unless the file says that they are linear.
bool is_encoded(const std::string& path) {
    const auto input = OIIO::ImageInput::open(path);
    if (!input) throw Error(ErrorCode::io, fmt::format("{}: cannot read: {}", path, OIIO::geterror()));
    const OIIO::ImageSpec& spec = input->spec();
    if (spec.format.is_floating_point()) return false;
    const std::string space = spec.get_string_attribute("oiio:ColorSpace");
    const bool linear = OIIO::Strutil::iequals(space, "linear") || spec.get_float_attribute("oiio:Gamma", 0) == 1;
    return !linear;
}

/// The picture among the layers: the one without a name, else the first (a file of one layer may name it).
std::size_t picture_layer(const Film& film) {
    for (std::size_t i = 0; i < film.layers.size(); ++i)
        if (film.layers[i].name.empty()) return i;
    return 0;
}

}  // namespace

Picture read_picture(const std::string& path) {
    const bool encoded = is_encoded(path);
    Film film = read_image(path);
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
