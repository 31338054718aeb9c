#include "rt_core/image/exr_writer.hpp"

#include <algorithm>
#include <bit>

#include "rt_core/api/parallel.hpp"
#include "rt_core/image/byte_writer.hpp"
#include "rt_core/image/half.hpp"

namespace cardioid {
namespace {

constexpr int zip = 3, lines_of_zip = 16, zip_level = 4;
constexpr std::uint32_t magic = 20000630, version = 2, long_names = 0x400;
constexpr std::size_t short_name = 31;

void attribute(ByteWriter& file, const std::string& name, const char* type, const std::vector<std::uint8_t>& value) {
    file.name(name);
    file.name(type);
    file.little(value.size(), 4);
    file.bytes(value);
}

std::vector<std::uint8_t> numbers(std::initializer_list<std::uint32_t> values) {
    ByteWriter out;
    for (const std::uint32_t x : values) out.little(x, 4);
    return out.take();
}

std::vector<std::uint8_t> channel_list(const std::vector<ExrChannel>& channels) {
    ByteWriter out;
    for (const ExrChannel& c : channels) {
        out.name(c.name);
        out.little(c.half ? 1 : 2, 4);
        out.little(0, 4);  // not perceptually linear
        out.little(1, 4);  // a value for every pixel across
        out.little(1, 4);  // and down
    }
    out.little(0, 1);
    return out.take();
}

void header(ByteWriter& file, int width, int height, const std::vector<ExrChannel>& channels,
            const Metadata& metadata) {
    const bool is_long =
        std::any_of(channels.begin(), channels.end(), [](const auto& c) { return c.name.size() > short_name; }) ||
        std::any_of(metadata.begin(), metadata.end(), [](const auto& m) { return m.first.size() > short_name; });
    file.little(magic, 4);
    file.little(is_long ? version | long_names : version, 4);
    const auto right = static_cast<std::uint32_t>(width - 1), bottom = static_cast<std::uint32_t>(height - 1);
    const auto one = std::bit_cast<std::uint32_t>(1.0F);
    attribute(file, "channels", "chlist", channel_list(channels));
    attribute(file, "compression", "compression", {zip});
    attribute(file, "dataWindow", "box2i", numbers({0, 0, right, bottom}));
    attribute(file, "displayWindow", "box2i", numbers({0, 0, right, bottom}));
    attribute(file, "lineOrder", "lineOrder", {0});
    attribute(file, "pixelAspectRatio", "float", numbers({one}));
    attribute(file, "screenWindowCenter", "v2f", numbers({0, 0}));
    attribute(file, "screenWindowWidth", "float", numbers({one}));
    for (const auto& [name, text] : metadata) attribute(file, name, "string", {text.begin(), text.end()});
    file.little(0, 1);
}

/// Puts the lowest bytes of a number, lowest first, and gives the place behind them.
template <class Number>
std::uint8_t* put(std::uint8_t* at, Number x) {
    for (std::size_t i = 0; i < sizeof x; ++i) *at++ = static_cast<std::uint8_t>(x >> 8 * i);
    return at;
}

/// The lines from y0 up to y1, each channel's values of a line together.
std::vector<std::uint8_t> lines(std::size_t width, std::size_t y0, std::size_t y1,
                                const std::vector<ExrChannel>& channels) {
    std::size_t size = 0;
    for (const ExrChannel& c : channels) size += c.half ? 2 : 4;
    std::vector<std::uint8_t> out(size * width * (y1 - y0));
    std::uint8_t* at = out.data();
    for (std::size_t y = y0; y < y1; ++y)
        for (const ExrChannel& c : channels)
            for (std::size_t i = y * width; i < (y + 1) * width; ++i) {
                const float x = c.first[i * c.stride];
                at = c.half ? put(at, to_half(x)) : put(at, std::bit_cast<std::uint32_t>(x));
            }
    return out;
}

/// What ZIP does before zlib: even bytes first, then odd ones, all as differences from the one before plus 128.
std::vector<std::uint8_t> predicted(const std::vector<std::uint8_t>& bytes) {
    std::vector<std::uint8_t> out(bytes.size());
    const std::size_t half = (bytes.size() + 1) / 2;
    for (std::size_t i = 0; i < bytes.size(); ++i) out[(i & 1 ? half : 0) + i / 2] = bytes[i];
    for (std::size_t i = out.size(); --i > 0;) out[i] = static_cast<std::uint8_t>(out[i] - out[i - 1] + 128);
    return out;
}

std::vector<std::uint8_t> block(std::vector<std::uint8_t> bytes) {
    std::vector<std::uint8_t> small = deflated(predicted(bytes), zip_level);
    // A reader takes a block of full size for one that is not compressed.
    return small.size() < bytes.size() ? small : bytes;
}

}  // namespace

std::vector<std::uint8_t> encode_exr(int width, int height, std::vector<ExrChannel> channels,
                                     const Metadata& metadata) {
    std::sort(channels.begin(), channels.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
    ByteWriter file;
    header(file, width, height, channels, metadata);
    std::vector<std::vector<std::uint8_t>> blocks(static_cast<std::size_t>((height + lines_of_zip - 1) / lines_of_zip));
    const auto last = static_cast<std::size_t>(height);
    parallel_for(static_cast<std::int64_t>(blocks.size()), [&](std::int64_t i) {
        const std::size_t y = static_cast<std::size_t>(i) * lines_of_zip;
        blocks[static_cast<std::size_t>(i)] =
            block(lines(static_cast<std::size_t>(width), y, std::min(y + lines_of_zip, last), channels));
    });
    std::uint64_t place = file.size() + 8 * blocks.size();
    for (const auto& b : blocks) {
        file.little(place, 8);
        place += 8 + b.size();
    }
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        file.little(i * lines_of_zip, 4);
        file.little(blocks[i].size(), 4);
        file.bytes(blocks[i]);
    }
    return file.take();
}

}  // namespace cardioid
