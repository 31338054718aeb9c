#pragma once
#include <cstdint>
#include <string_view>
#include <vector>

namespace cardioid {

/// Bytes of a file in the making.
class ByteWriter {
public:
    /// The lowest `size` bytes of a number, lowest first.
    void little(std::uint64_t x, int size) {
        for (int i = 0; i < size; ++i) bytes_.push_back(static_cast<std::uint8_t>(x >> 8 * i));
    }
    /// Four bytes, highest first.
    void big(std::uint32_t x) {
        for (int i = 3; i >= 0; --i) bytes_.push_back(static_cast<std::uint8_t>(x >> 8 * i));
    }
    void text(std::string_view text) { bytes_.insert(bytes_.end(), text.begin(), text.end()); }
    /// A text and the zero that ends it.
    void name(std::string_view name) {
        text(name);
        bytes_.push_back(0);
    }
    void bytes(const std::vector<std::uint8_t>& more) { bytes_.insert(bytes_.end(), more.begin(), more.end()); }

    [[nodiscard]] std::size_t size() const { return bytes_.size(); }
    [[nodiscard]] std::vector<std::uint8_t> take() { return std::move(bytes_); }
    [[nodiscard]] const std::vector<std::uint8_t>& all() const { return bytes_; }

private:
    std::vector<std::uint8_t> bytes_;
};

/// zlib's stream of some bytes; level 1 (quick) to 9 (small).
std::vector<std::uint8_t> deflated(const std::vector<std::uint8_t>& bytes, int level);

}  // namespace cardioid
