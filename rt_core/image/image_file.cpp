#include "rt_core/image/image_file.hpp"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <algorithm>
#include <array>
#include <cctype>
#include <fmt/format.h>
#include <string_view>

#include "rt_core/api/error.hpp"
#include "rt_core/image/atomic_file.hpp"
#include "rt_core/image/encode.hpp"
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

void add_metadata(OIIO::ImageSpec& spec, const Metadata& metadata, bool any_name) {
    std::string lines;
    for (const auto& [name, text] : metadata) {
        if (any_name) spec.attribute(name, text);
        lines += name + ": " + one_line(text) + "\n";
    }
    if (!any_name && !lines.empty()) spec.attribute(description, lines);
}

/// Encodes into memory and puts the file in its place; type is that of `data`.
void write(const std::string& path, const OIIO::ImageSpec& spec, const OIIO::TypeDesc& type, const void* data) {
    const auto output = OIIO::ImageOutput::create(path);
    if (!output) throw Error(ErrorCode::io, fmt::format("{}: {}", path, OIIO::geterror()));
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    if (!output->set_ioproxy(&memory) || !output->open(path, spec) || !output->write_image(type, data) ||
        !output->close())
        throw Error(ErrorCode::io, fmt::format("{}: {}", path, output->geterror()));
    write_whole_file(path, std::as_bytes(std::span(bytes)));
}

void write_encoded(const std::string& path, const Film& film, const Layer& layer, const ImageWriteSettings& settings) {
    OIIO::ImageSpec spec(film.width, film.height, 3, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute("CompressionQuality", 95);
    add_metadata(spec, settings.metadata, false);
    const std::vector<std::uint8_t> bytes = encode_8bit(layer, settings.exposure);
    write(path, spec, OIIO::TypeDesc::UINT8, bytes.data());
}

/// The given layers side by side in one file, linear.
void write_linear(const std::string& path, const Film& film, std::span<const Layer> layers,
                  const ImageWriteSettings& settings, bool any_name) {
    int channels = 0;
    for (const Layer& layer : layers) channels += layer.channels;
    const OIIO::TypeDesc format = settings.half && any_name ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::FLOAT;
    OIIO::ImageSpec spec(film.width, film.height, channels, format);
    spec.attribute("oiio:ColorSpace", "Linear");
    spec.channelnames.clear();
    for (const Layer& layer : layers)
        for (int c = 0; c < layer.channels; ++c) {
            spec.channelnames.push_back(channel_name(layer, c));
            // Ids and distances need more than half's eleven bits.
            spec.channelformats.push_back(layer.channels == 1 ? OIIO::TypeDesc::FLOAT : format);
        }
    if (!any_name) spec.channelformats.clear();
    add_metadata(spec, settings.metadata, any_name);
    std::vector<float> data;
    const std::size_t n = static_cast<std::size_t>(film.width) * static_cast<std::size_t>(film.height);
    data.reserve(n * static_cast<std::size_t>(channels));
    for (std::size_t i = 0; i < n; ++i)
        for (const Layer& layer : layers) {
            const auto width = static_cast<std::ptrdiff_t>(layer.channels);
            const auto at = layer.pixels.begin() + static_cast<std::ptrdiff_t>(i) * width;
            data.insert(data.end(), at, at + width);
        }
    write(path, spec, OIIO::TypeDesc::FLOAT, data.data());
}

/// "out.png" and "direct" give "out.direct.png".
std::string beside(const std::string& path, const std::string& layer) {
    const std::size_t dot = path.size() - extension_of(path).size();
    return path.substr(0, dot) + "." + layer + path.substr(dot);
}

void read_metadata(const OIIO::ImageSpec& spec, Metadata& metadata) {
    for (const OIIO::ParamValue& entry : spec.extra_attribs) {
        if (entry.type() != OIIO::TypeDesc::STRING) continue;
        const std::string name = entry.name().string(), text = entry.get_string();
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
void split_layers(const OIIO::ImageSpec& spec, const std::vector<float>& data, Film& film) {
    const auto channels = static_cast<std::size_t>(spec.nchannels);
    std::vector<std::size_t> layer_of(channels);
    for (std::size_t c = 0; c < channels; ++c) {
        const std::string full = spec.channel_name(static_cast<int>(c));
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
}

void write_image(const std::string& path, const Film& film, const ImageWriteSettings& settings) {
    const Extension& extension = known_extension(path);
    const std::span<const Layer> layers(film.layers);
    if (extension.channels) return write_linear(path, film, layers, settings, true);
    for (const Layer& layer : layers) {
        const std::string file = layer.name.empty() ? path : beside(path, layer.name);
        if (extension.linear)
            write_linear(file, film, std::span(&layer, 1), settings, false);
        else
            write_encoded(file, film, layer, settings);
    }
}

Film read_image(const std::string& path, Metadata* metadata) {
    const auto input = OIIO::ImageInput::open(path);
    if (!input) throw Error(ErrorCode::io, fmt::format("{}: cannot read: {}", path, OIIO::geterror()));
    const OIIO::ImageSpec& spec = input->spec();
    Film film;
    film.width = spec.width;
    film.height = spec.height;
    std::vector<float> data(spec.image_pixels() * static_cast<std::size_t>(spec.nchannels));
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, data.data()))
        throw Error(ErrorCode::io, fmt::format("{}: cannot read: {}", path, input->geterror()));
    split_layers(spec, data, film);
    if (metadata) read_metadata(spec, *metadata);
    return film;
}

}  // namespace cardioid
