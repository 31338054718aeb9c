#pragma once
#include <bit>
#include <cstdint>
#include <fmt/format.h>
#include <string>
#include <string_view>

#include "rt_core/api/error.hpp"

namespace cardioid::formats::brlcad {

/// Big-endian values of a stretch of bytes, each length checked before it is used.
class ByteReader {
public:
    /// `file` and `offset` of the first byte are for messages.
    ByteReader(std::string_view bytes, const std::string& file, std::size_t offset)
        : bytes_(bytes), file_(&file), offset_(offset) {}

    [[nodiscard]] bool at_end() const { return at_ == bytes_.size(); }
    [[nodiscard]] std::size_t left() const { return bytes_.size() - at_; }
    [[nodiscard]] std::string place() const { return fmt::format("{}:{}", *file_, offset_ + at_); }

    std::string_view take(std::uint64_t n, const char* what) {
        if (n > left())
            fail(fmt::format("found the end of the data {} bytes on, wanted {} bytes of {}", left(), n, what));
        const std::string_view out = bytes_.substr(at_, static_cast<std::size_t>(n));
        at_ += out.size();
        return out;
    }
    /// A number of 1, 2, 4 or 8 bytes: width 0 to 3.
    std::uint64_t whole(unsigned width, const char* what) {
        std::uint64_t value = 0;
        for (const char c : take(1U << width, what)) value = value << 8 | static_cast<unsigned char>(c);
        return value;
    }
    double real(const char* what) { return std::bit_cast<double>(whole(3, what)); }
    /// A text that ends with a zero byte.
    std::string text(const char* what) {
        const std::size_t end = bytes_.find('\0', at_);
        if (end == std::string_view::npos) fail(fmt::format("found no end of {}, wanted a zero byte", what));
        std::string out(bytes_.substr(at_, end - at_));
        at_ = end + 1;
        return out;
    }
    [[noreturn]] void fail(const std::string& what) const { throw Error(ErrorCode::bad_input, place() + ": " + what); }

private:
    std::string_view bytes_;
    const std::string* file_;
    std::size_t offset_, at_ = 0;
};

}  // namespace cardioid::formats::brlcad
