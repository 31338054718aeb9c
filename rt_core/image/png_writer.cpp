#include "rt_core/image/png_writer.hpp"

#include <cstdlib>
#include <zlib.h>

#include "rt_core/image/byte_writer.hpp"

namespace cardioid {
namespace {

constexpr int level = 6;
constexpr std::size_t pixel = 3;

void chunk(ByteWriter& file, std::string_view type, const std::vector<std::uint8_t>& data) {
    file.big(static_cast<std::uint32_t>(data.size()));
    ByteWriter body;
    body.text(type);
    body.bytes(data);
    file.bytes(body.all());
    file.big(static_cast<std::uint32_t>(crc32(0, body.all().data(), static_cast<uInt>(body.size()))));
}

std::uint8_t paeth(int a, int b, int c) {
    const int pa = std::abs(b - c), pb = std::abs(a - c), pc = std::abs(a + b - 2 * c);
    return static_cast<std::uint8_t>(pa <= pb && pa <= pc ? a : pb <= pc ? b : c);
}

/// A row as its differences from what is left of it and above it (section 9.2, type 4, Paeth's predictor).
void filtered_row(const std::uint8_t* row, const std::uint8_t* above, std::size_t size, std::uint8_t* out) {
    for (std::size_t i = 0; i < size; ++i) {
        const int left = i < pixel ? 0 : row[i - pixel], up = above ? above[i] : 0;
        const int corner = i < pixel || !above ? 0 : above[i - pixel];
        out[i] = static_cast<std::uint8_t>(row[i] - paeth(left, up, corner));
    }
}

}  // namespace

std::vector<std::uint8_t> encode_png(int width, int height, const std::vector<std::uint8_t>& rgb,
                                     const std::string& description) {
    ByteWriter file;
    file.text("\x89PNG\r\n\x1a\n");
    ByteWriter head;
    head.big(static_cast<std::uint32_t>(width));
    head.big(static_cast<std::uint32_t>(height));
    for (const unsigned x : {8U, 2U, 0U, 0U, 0U}) head.little(x, 1);  // bits, RGB, deflate, filters, not interlaced
    chunk(file, "IHDR", head.all());
    chunk(file, "sRGB", {0});
    if (!description.empty()) {
        ByteWriter text;
        text.name("Description");
        text.text(description);
        chunk(file, "tEXt", text.all());
    }
    const std::size_t row = static_cast<std::size_t>(width) * pixel;
    std::vector<std::uint8_t> rows((row + 1) * static_cast<std::size_t>(height));
    for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y) {
        rows[y * (row + 1)] = 4;
        filtered_row(&rgb[y * row], y > 0 ? &rgb[(y - 1) * row] : nullptr, row, &rows[y * (row + 1) + 1]);
    }
    chunk(file, "IDAT", deflated(rows, level));
    chunk(file, "IEND", {});
    return file.take();
}

}  // namespace cardioid
