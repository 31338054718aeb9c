/// The module cardioid_images.so: all that touches OpenImageIO.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <string_view>

#include "rt_core/image/image_codecs.hpp"

namespace cardioid {
namespace {

/// Whole numbers are what a display is given, unless the file says that they are linear.
bool is_encoded(const OIIO::ImageSpec& spec) {
    if (spec.format.is_floating_point()) return false;
    const std::string space = spec.get_string_attribute("oiio:ColorSpace");
    return !OIIO::Strutil::iequals(space, "linear") && spec.get_float_attribute("oiio:Gamma", 0) != 1;
}

std::string read(const std::string& path, std::int64_t most_pixels, RawImage& image) {
    const auto input = OIIO::ImageInput::open(path);
    if (!input) return OIIO::geterror();
    const OIIO::ImageSpec& spec = input->spec();
    if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1) return "it has no pixels";
    image.width = spec.width, image.height = spec.height;
    image.encoded = is_encoded(spec);
    for (int c = 0; c < spec.nchannels; ++c) image.channels.push_back(spec.channel_name(c));
    for (const OIIO::ParamValue& entry : spec.extra_attribs)
        if (entry.type() == OIIO::TypeDesc::STRING)
            image.metadata.emplace_back(entry.name().string(), entry.get_string());
    if (std::int64_t{spec.width} * spec.height > most_pixels) return "";
    image.values.resize(spec.image_pixels() * static_cast<std::size_t>(spec.nchannels));
    const bool good = input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, image.values.data());
    return good ? "" : input->geterror();
}

/// Writes into memory, so that we see every failure of the disk ourselves.
std::string encode(const std::string& path, const RawImage& image, std::vector<unsigned char>& bytes) {
    const auto output = OIIO::ImageOutput::create(path);
    if (!output) return OIIO::geterror();
    OIIO::ImageSpec spec(image.width, image.height, static_cast<int>(image.channels.size()),
                         image.encoded ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::FLOAT);
    spec.channelnames = image.channels;
    spec.attribute("oiio:ColorSpace", image.encoded ? "sRGB" : "Linear");
    spec.attribute("CompressionQuality", 95);
    if (output->supports("channelformats"))
        for (const bool half : image.half)
            spec.channelformats.push_back(half ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::FLOAT);
    // Else an EXR file holds the time of day, and no two runs write the same.
    if (std::string_view(output->format_name()) == "openexr") spec.attribute("DateTime", "1970:01:01 00:00:00");
    for (const auto& [name, text] : image.metadata) spec.attribute(name, text);
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const bool good = output->set_ioproxy(&memory) && output->open(path, spec) &&
                      output->write_image(OIIO::TypeDesc::FLOAT, image.values.data()) && output->close();
    return good ? "" : output->geterror();
}

constexpr ImageCodecs codecs{read, encode};

}  // namespace
}  // namespace cardioid

extern "C" __attribute__((visibility("default"))) const cardioid::ImageCodecs* cardioid_image_codecs() {
    return &cardioid::codecs;
}
