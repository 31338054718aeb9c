#include "rt_core/image/image_file.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <string_view>

#include "rt_core/api/error.hpp"
#include "rt_core/image/atomic_file.hpp"
#include "rt_core/image/encode.hpp"
#include "rt_core/image/image_codecs.hpp"
#include "rt_core/scene/nearest_name.hpp"

namespace cardioid {

namespace {

/// What we write: formats that OpenImageIO can write into memory, so that we see every failure of the disk. (TIFF is
/// not among them: OpenImageIO 2.4 leaves its directory incomplete there.)
struct Extension {
    std::string_view name;
    bool linear;    ///< floats, not encoded
    bool channels;  ///< holds more layers than the picture
};
constexpr std::array extensions{
    Extension{".png", false, false}, Extension{".jpg", false, false}, Extension{".jpeg", false, false},
    Extension{".exr", true, true},   Extension{".hdr", true, false},  Extension{".tga", false, false},
    Extension{".bmp", false, false}, Extension{".ppm", false, false}, Extension{".webp", false, false}};

/// The largest number of 16 bits; what is finite stays so.
constexpr float most_half = 65504;

/// The text that stands for all metadata where a format has no entries of any name: "name: text" lines.
constexpr const char* description = "ImageDescription";

std::string extension_of(const std::string& path) {
    const std::size_t dot = path.find_last_of("./");
    if (dot == std::string::npos || path[dot] == '/') return {};
    std::string text = path.substr(dot);
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
    return text;
}

const Extension& known_extension(const std::string& path) {
    const std::string wanted = extension_of(path);
    std::vector<std::string_view> names;
    for (const Extension& e : extensions) {
        if (e.name == wanted) return e;
        names.push_back(e.name);
    }
    throw Error(ErrorCode::usage, fmt::format("{}: {} is no picture format this program writes{}; it writes {}", path,
                                              wanted.empty() ? "a name without extension" : '"' + wanted + '"',
                                              did_you_mean(wanted, names), fmt::join(names, " ")));
}

/// Names of a layer's channels within a file of many layers.
std::string channel_name(const Layer& layer, int channel) {
    static constexpr std::array colour{"R", "G", "B", "A"}, vector{"X", "Y", "Z", "W"};
    const std::string prefix = layer.name.empty() ? "" : layer.name + ".";
    if (layer.channels == 1) return prefix + (layer.name == "depth" ? "Z" : layer.name == "region" ? "id" : "Y");
    return prefix + (layer.name == "normal" ? vector : colour)[static_cast<std::size_t>(channel) % 4];
}

std::string one_line(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

/// All entries as "name: text" lines.
std::string described(const Metadata& metadata) {
    std::string lines;
    for (const auto& [name, text] : metadata) lines += name + ": " + one_line(text) + "\n";
    return lines;
}

Metadata as_description(const Metadata& metadata) {
    if (metadata.empty()) return {};
    return {{description, described(metadata)}};
}

/// Encodes into memory and puts the file in its place.
void write(const std::string& path, const RawImage& image) {
    std::vector<unsigned char> bytes;
    const std::string failure = image_codecs().encode(path, image, bytes);
    if (!failure.empty()) throw Error(ErrorCode::io, fmt::format("{}: {}", path, failure));
    write_whole_file(path, std::as_bytes(std::span(bytes)));
}

void write_encoded(const std::string& path, const Film& film, const Layer& layer, const ImageWriteSettings& settings) {
    const std::vector<std::uint8_t> bytes = encode_8bit(layer, settings.exposure);
    RawImage image{.width = film.width,
                   .height = film.height,
                   .channels = {"R", "G", "B"},
                   .encoded = true,
                   .values = {},
                   .half = {},
                   .metadata = as_description(settings.metadata)};
    image.values.reserve(bytes.size());
    for (const std::uint8_t byte : bytes) image.values.push_back(static_cast<float>(byte) / 255);
    write(path, image);
}

/// All layers side by side.
void write_exr(const std::string& path, const Film& film, const ImageWriteSettings& settings) {
    RawImage image{.width = film.width,
                   .height = film.height,
                   .channels = {},
                   .values = {},
                   .half = {},
                   .metadata = settings.metadata};
    for (const Layer& layer : film.layers)
        for (int c = 0; c < layer.channels; ++c) {
            image.channels.push_back(channel_name(layer, c));
            // Ids and distances need more than half's eleven bits.
            image.half.push_back(settings.half && layer.channels > 1);
        }
    const std::size_t n = static_cast<std::size_t>(film.width) * static_cast<std::size_t>(film.height);
    image.values.reserve(n * image.channels.size());
    for (std::size_t i = 0; i < n; ++i)
        for (const Layer& layer : film.layers) {
            const auto channels = static_cast<std::size_t>(layer.channels);
            const bool half = settings.half && channels > 1;
            for (std::size_t c = 0; c < channels; ++c) {
                const float x = layer.pixels[i * channels + c];
                image.values.push_back(half && std::isfinite(x) ? std::clamp(x, -most_half, most_half) : x);
            }
        }
    write(path, image);
}

/// One layer as floats.
void write_linear(const std::string& path, const Film& film, const Layer& layer, const ImageWriteSettings& settings) {
    RawImage image{.width = film.width,
                   .height = film.height,
                   .channels = {},
                   .values = layer.pixels,
                   .half = {},
                   .metadata = as_description(settings.metadata)};
    for (int c = 0; c < layer.channels; ++c) image.channels.push_back(channel_name(layer, c));
    write(path, image);
}

/// "out.png" and "direct" give "out.direct.png".
std::string beside(const std::string& path, const std::string& layer) {
    const std::size_t dot = path.size() - extension_of(path).size();
    return path.substr(0, dot) + "." + layer + path.substr(dot);
}

void read_metadata(const Metadata& entries, Metadata& metadata) {
    for (const auto& [name, text] : entries) {
        if (name != description) {
            if (!name.starts_with("oiio:")) metadata.emplace_back(name, text);
            continue;
        }
        for (std::size_t at = 0; at < text.size();) {
            const std::size_t end = std::min(text.find('\n', at), text.size());
            const std::string line = text.substr(at, end - at);
            const std::size_t colon = line.find(": ");
            if (colon != std::string::npos) metadata.emplace_back(line.substr(0, colon), line.substr(colon + 2));
            at = end + 1;
        }
    }
}

/// Puts interleaved channels into the layers that their names tell.
void split_layers(const RawImage& image, Film& film) {
    const std::vector<float>& data = image.values;
    const std::size_t channels = image.channels.size();
    std::vector<std::size_t> layer_of(channels);
    for (std::size_t c = 0; c < channels; ++c) {
        const std::string& full = image.channels[c];
        const std::size_t dot = full.rfind('.');
        const std::string name = dot == std::string::npos ? "" : full.substr(0, dot);
        const auto at =
            std::find_if(film.layers.begin(), film.layers.end(), [&](const Layer& l) { return l.name == name; });
        layer_of[c] = static_cast<std::size_t>(at - film.layers.begin());
        if (at == film.layers.end())
            film.layers.push_back({name, 1, {}});
        else
            ++at->channels;
    }
    const std::size_t n = data.size() / channels;
    for (Layer& layer : film.layers) layer.pixels.reserve(n * static_cast<std::size_t>(layer.channels));
    for (std::size_t i = 0; i < n * channels; ++i) film.layers[layer_of[i % channels]].pixels.push_back(data[i]);
}

}  // namespace

void check_image_path(const std::string& path) {
    static_cast<void>(known_extension(path));
    check_writable(path);
    begin_loading_image_codecs();
}

void check_image_formats() { static_cast<void>(image_codecs()); }

void write_image(const std::string& path, const Film& film, const ImageWriteSettings& settings) {
    const Extension& extension = known_extension(path);
    if (extension.channels) return write_exr(path, film, settings);
    for (const Layer& layer : film.layers) {
        const std::string file = layer.name.empty() ? path : beside(path, layer.name);
        if (extension.linear)
            write_linear(file, film, layer, settings);
        else
            write_encoded(file, film, layer, settings);
    }
}

Film read_image(const std::string& path, Metadata* metadata, bool* encoded) {
    const RawImage image = read_raw_image(path, std::numeric_limits<std::int64_t>::max());
    Film film{image.width, image.height, {}};
    split_layers(image, film);
    if (metadata) read_metadata(image.metadata, *metadata);
    if (encoded) *encoded = image.encoded;
    return film;
}

}  // namespace cardioid
