#include <algorithm>
#include <zlib.h>

#include "formats/brlcad/read/readers.hpp"
#include "rt_core/api/error.hpp"

namespace cardioid::formats::brlcad {

namespace {

/// Ends zlib's state however the function is left.
struct Inflating {
    z_stream stream{};
    /// 32 more than the window's bits: zlib tells gzip and zlib headers apart.
    Inflating() { ready = inflateInit2(&stream, 15 + 32) == Z_OK; }
    ~Inflating() {
        if (ready) inflateEnd(&stream);
    }
    Inflating(const Inflating&) = delete;
    Inflating& operator=(const Inflating&) = delete;
    bool ready = false;
};

}  // namespace

std::string unpack(std::string_view packed, std::size_t most, const std::string& place) {
    Inflating inflating;
    if (!inflating.ready) throw Error(ErrorCode::limit, place + ": no memory to unpack");
    z_stream& stream = inflating.stream;
    std::string in(packed), out;
    stream.next_in = reinterpret_cast<Bytef*>(in.data());
    stream.avail_in = static_cast<uInt>(std::min<std::size_t>(in.size(), 0xFFFFFFFFU));
    char buffer[1 << 14];
    for (int state = Z_OK; state != Z_STREAM_END;) {
        stream.next_out = reinterpret_cast<Bytef*>(buffer);
        stream.avail_out = sizeof buffer;
        state = inflate(&stream, Z_NO_FLUSH);
        if (state != Z_OK && state != Z_STREAM_END)
            throw Error(ErrorCode::bad_input, place + ": found packed data that zlib cannot unpack");
        out.append(buffer, sizeof buffer - stream.avail_out);
        if (out.size() > most) throw Error(ErrorCode::limit, place + ": packed data are larger than 256 MB unpacked");
    }
    return out;
}

}  // namespace cardioid::formats::brlcad
