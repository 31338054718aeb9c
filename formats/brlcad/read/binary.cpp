#include <algorithm>

#include "formats/brlcad/read/byte_reader.hpp"
#include "formats/brlcad/read/readers.hpp"
#include "formats/brlcad/solid_kinds.hpp"

namespace cardioid::formats::brlcad {

namespace {

constexpr unsigned char first_byte = 0x76, last_byte = 0x35;
constexpr unsigned present = 0x20;
constexpr int brlcad_major = 1, attribute_major = 2, data_major = 9, combination_minor = 31;
/// Of all that is unpacked from one file.
constexpr std::size_t most_unpacked = std::size_t{1} << 28;

struct Header {
    unsigned flags = 0, attribute_flags = 0, body_flags = 0;
    int major = 0, minor = 0;
    [[nodiscard]] bool is_free() const { return (flags & 3) == 2; }
    [[nodiscard]] bool is_file_header() const { return (flags & 3) == 1; }
};

class BinaryReader {
public:
    BinaryReader(std::string_view bytes, const std::string& file) : all_(bytes), file_(file) {}

    Database run() {
        if (!looks_binary(all_))
            throw Error(ErrorCode::bad_input,
                        file_ + ":0: found no BRL-CAD database of version 5, wanted the bytes 76 01 00 00 00 00 01 35");
        std::size_t at = 0;
        while (at < all_.size()) at += object(at);
        return std::move(database_);
    }

private:
    /// Reads the object at `at` and returns its length.
    std::size_t object(std::size_t at) {
        ByteReader in(all_.substr(at), file_, at);
        if (in.whole(0, "an object") != first_byte)
            throw Error(ErrorCode::bad_input,
                        fmt::format("{}:{}: found byte {:#04x}, wanted the start of an object, 0x76", file_, at,
                                    static_cast<unsigned char>(all_[at])));
        Header header;
        header.flags = static_cast<unsigned>(in.whole(0, "flags"));
        header.attribute_flags = static_cast<unsigned>(in.whole(0, "flags"));
        header.body_flags = static_cast<unsigned>(in.whole(0, "flags"));
        header.major = static_cast<int>(in.whole(0, "a type"));
        header.minor = static_cast<int>(in.whole(0, "a type"));
        const std::size_t start = all_.size() - at - in.left();
        const std::uint64_t eights = in.whole(header.flags >> 6, "an object's length");
        const std::size_t head = all_.size() - at - in.left();
        if (eights > (all_.size() - at) / 8 || eights * 8 < head + 1)
            throw Error(ErrorCode::bad_input,
                        fmt::format("{}:{}: found an object of {} times 8 bytes, wanted at most the "
                                    "{} bytes that are left",
                                    file_, at + start, eights, all_.size() - at));
        const auto length = static_cast<std::size_t>(eights * 8);
        if (static_cast<unsigned char>(all_[at + length - 1]) != last_byte)
            throw Error(ErrorCode::bad_input,
                        fmt::format("{}:{}: found no end of an object, wanted byte 0x35", file_, at + length - 1));
        if (!header.is_free() && !header.is_file_header())
            contents(header, ByteReader(all_.substr(at + head, length - head - 1), file_, at + head), at);
        return length;
    }

    void contents(const Header& header, ByteReader in, std::size_t at) {
        Object object;
        object.place = fmt::format("{}:{}", file_, at);
        if (header.flags & present) object.name = counted_text(in, header.flags >> 3 & 3);
        const std::string attributes = part(in, header.attribute_flags, "attributes");
        const std::string body = part(in, header.body_flags, "a body");
        if (header.major == attribute_major || object.name == "_GLOBAL") {
            each_attribute(attributes, at, [&](const std::string& key, const std::string& value) {
                set_global(database_, key, value);
            });
            return;
        }
        if ((header.major != brlcad_major && header.major != data_major) || object.name.empty()) return;
        if (header.major == data_major) {
            object.solid = {.kind = SolidKind::data, .type = "binunif", .bytes = body, .element = header.minor};
        } else if (header.minor == combination_minor) {
            object.combination = read_combination(body, file_, at);
            each_attribute(attributes, at, [&](const std::string& key, const std::string& value) {
                set_attribute(*object.combination, key, value);
            });
        } else {
            object.solid = read_body(header.minor, body, file_, at);
        }
        database_.add(std::move(object));
    }

    static std::string counted_text(ByteReader& in, unsigned width) {
        const std::string_view bytes = in.take(in.whole(width, "a name's length"), "a name");
        return std::string(bytes.substr(0, bytes.find('\0')));
    }

    /// Attributes or a body, unpacked.
    std::string part(ByteReader& in, unsigned flags, const char* what) {
        if (!(flags & present)) return {};
        const std::string place = in.place();
        const std::string_view bytes = in.take(in.whole(flags >> 6, what), what);
        const unsigned packing = flags & 7;
        if (packing == 0) return std::string(bytes);
        if (packing != 1)
            throw Error(ErrorCode::bad_input,
                        fmt::format("{}: found {} packed by method {}, wanted none or gzip (1)", place, what, packing));
        std::string out = unpack(bytes, most_unpacked - unpacked_, place);
        unpacked_ += out.size();
        return out;
    }

    template <class Visit>
    void each_attribute(const std::string& bytes, std::size_t at, const Visit& visit) {
        ByteReader in(bytes, file_, at);
        while (!in.at_end()) {
            const std::string key = in.text("an attribute's name");
            if (key.empty()) break;
            visit(key, in.text("an attribute's value"));
        }
    }

    std::string_view all_;
    const std::string& file_;
    Database database_;
    std::size_t unpacked_ = 0;
};

}  // namespace

bool looks_binary(std::string_view head) {
    return head.starts_with(std::string_view("\x76\x01\x00\x00\x00\x00\x01\x35", 8));
}

Database read_binary(std::string_view bytes, const std::string& file) { return BinaryReader(bytes, file).run(); }

}  // namespace cardioid::formats::brlcad
