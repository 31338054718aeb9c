#include "rt_core/image/byte_writer.hpp"

#include <new>
#include <zlib.h>

namespace cardioid {

std::vector<std::uint8_t> deflated(const std::vector<std::uint8_t>& bytes, int level) {
    uLongf size = compressBound(static_cast<uLong>(bytes.size()));
    std::vector<std::uint8_t> out(size);
    // With room enough it fails for want of memory alone.
    if (compress2(out.data(), &size, bytes.data(), static_cast<uLong>(bytes.size()), level) != Z_OK)
        throw std::bad_alloc();
    out.resize(size);
    return out;
}

}  // namespace cardioid
