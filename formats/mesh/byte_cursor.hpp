#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace cardioid::formats {

/// Walks through the bytes of a binary file. Errors are Error(bad_input) with file:byte.
class ByteCursor {
public:
    /// The bytes stand from position `at` of the file on.
    ByteCursor(std::string_view bytes, std::string file, std::size_t at, std::endian order)
        : rest_(bytes), file_(std::move(file)), at_(at), swap_(order != std::endian::native) {}

    [[nodiscard]] std::size_t left() const { return rest_.size(); }
    [[nodiscard]] std::size_t position() const { return at_; }

    template <class T>
    T take() {
        if (rest_.size() < sizeof(T)) fail("the end of the file", "more data");
        std::array<char, sizeof(T)> bytes;
        for (std::size_t i = 0; i < sizeof(T); ++i) bytes[i] = rest_[swap_ ? sizeof(T) - 1 - i : i];
        skip(sizeof(T));
        return std::bit_cast<T>(bytes);
    }
    /// Passes over at most what is left.
    void skip(std::size_t bytes) {
        bytes = std::min(bytes, rest_.size());
        rest_.remove_prefix(bytes);
        at_ += bytes;
    }
    /// "file:byte N: found X, wanted Y".
    [[noreturn]] void fail(std::string_view found, std::string_view wanted) const;

private:
    std::string_view rest_;
    std::string file_;
    std::size_t at_;
    bool swap_;
};

}  // namespace cardioid::formats
