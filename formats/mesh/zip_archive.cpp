#include "formats/mesh/zip_archive.hpp"

#include <algorithm>
#include <zlib.h>

#include "rt_core/api/error.hpp"

namespace cardioid::formats {

namespace {

constexpr std::size_t longest = std::size_t{4} << 30;
constexpr std::string_view end_mark("PK\x05\x06", 4), entry_mark("PK\x01\x02", 4), local_mark("PK\x03\x04", 4);
constexpr std::size_t entry_size = 46, local_size = 30;  ///< without names

[[noreturn]] void refuse(const std::string& file, const char* found) {
    throw Error(ErrorCode::bad_input, file + ": found " + found + ", wanted a ZIP archive");
}

/// A number of `bytes` bytes, the least first.
std::size_t number(std::string_view archive, std::size_t at, std::size_t bytes, const std::string& file) {
    if (at + bytes > archive.size()) refuse(file, "the end of the file");
    std::size_t out = 0;
    for (std::size_t i = bytes; i-- > 0;) out = out << 8 | static_cast<unsigned char>(archive[at + i]);
    return out;
}

std::string inflated(std::string_view packed, std::size_t size, const std::string& file) {
    std::string out(size, '\0');
    z_stream stream{};
    if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) throw Error(ErrorCode::limit, "zlib cannot be started");
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
    stream.avail_in = static_cast<uInt>(packed.size());
    stream.next_out = reinterpret_cast<Bytef*>(out.data());
    stream.avail_out = static_cast<uInt>(size);
    const int status = inflate(&stream, Z_FINISH);
    inflateEnd(&stream);
    if (status != Z_STREAM_END || stream.avail_out != 0) refuse(file, "damaged data");
    return out;
}

std::string deflated(const std::string& content) {
    if (content.size() >= longest) throw Error(ErrorCode::limit, "a file of 4 GB or more for a ZIP archive");
    z_stream stream{};
    if (deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, -MAX_WBITS, 8, Z_DEFAULT_STRATEGY) != Z_OK)
        throw Error(ErrorCode::limit, "zlib cannot be started");
    std::string out(deflateBound(&stream, content.size()), '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(content.data()));
    stream.avail_in = static_cast<uInt>(content.size());
    stream.next_out = reinterpret_cast<Bytef*>(out.data());
    stream.avail_out = static_cast<uInt>(out.size());
    deflate(&stream, Z_FINISH);
    out.resize(stream.total_out);
    deflateEnd(&stream);
    return out;
}

std::size_t checksum(const std::string& content) {
    return crc32_z(0, reinterpret_cast<const Bytef*>(content.data()), content.size());
}

void append(std::string& out, std::size_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) out += static_cast<char>(value >> (8 * i) & 0xFF);
}

}  // namespace

std::vector<ZipEntry> zip_entries(std::string_view archive, const std::string& file) {
    const std::size_t end = archive.rfind(end_mark);
    if (end == std::string_view::npos) refuse(file, "no directory");
    const std::size_t count = number(archive, end + 10, 2, file);
    std::size_t at = number(archive, end + 16, 4, file);
    std::vector<ZipEntry> out;
    for (std::size_t i = 0; i < count; ++i) {
        if (archive.substr(std::min(at, archive.size()), 4) != entry_mark) refuse(file, "a damaged directory");
        const auto field = [&](std::size_t offset, std::size_t bytes) {
            return number(archive, at + offset, bytes, file);
        };
        ZipEntry entry;
        entry.method = static_cast<int>(field(10, 2));
        entry.packed = field(20, 4), entry.size = field(24, 4), entry.offset = field(42, 4);
        const std::size_t name = field(28, 2), more = field(30, 2) + field(32, 2);
        if (at + entry_size + name > archive.size()) refuse(file, "the end of the file");
        entry.name = archive.substr(at + entry_size, name);
        at += entry_size + name + more;
        out.push_back(std::move(entry));
    }
    return out;
}

std::string unzip(std::string_view archive, const ZipEntry& entry, const std::string& file) {
    if (archive.substr(std::min(entry.offset, archive.size()), 4) != local_mark) refuse(file, "a damaged entry");
    if (entry.size >= longest) throw Error(ErrorCode::limit, file + ": found an entry of 4 GB or more");
    const std::size_t names = number(archive, entry.offset + 26, 2, file) + number(archive, entry.offset + 28, 2, file);
    const std::size_t begin = entry.offset + local_size + names;
    if (begin + entry.packed > archive.size()) refuse(file, "the end of the file");
    // Deflate packs a thousandfold at most: a header that promises more would only fill the memory.
    if (entry.method == 8 && entry.size / 1100 > entry.packed) refuse(file, "an entry of an impossible size");
    const std::string_view packed = archive.substr(begin, entry.packed);
    if (entry.method == 0) return std::string(packed);
    if (entry.method == 8) return inflated(packed, entry.size, file);
    refuse(file, "an unknown way of packing");
}

std::string zip(const std::vector<std::pair<std::string, std::string>>& files) {
    std::string out, directory;
    for (const auto& [name, content] : files) {
        const std::string packed = deflated(content);
        std::string facts;  // what both headers say: version, flags, method, time, date, checksum, sizes, lengths
        append(facts, 20, 2), append(facts, 0, 2), append(facts, 8, 2), append(facts, 0, 2), append(facts, 0x21, 2);
        append(facts, checksum(content), 4), append(facts, packed.size(), 4), append(facts, content.size(), 4);
        append(facts, name.size(), 2), append(facts, 0, 2);
        directory.append(entry_mark);
        append(directory, 20, 2);
        directory += facts;
        append(directory, 0, 2), append(directory, 0, 2), append(directory, 0, 2), append(directory, 0, 4);
        append(directory, out.size(), 4);
        directory += name;
        out.append(local_mark) += facts + name + packed;
        if (out.size() >= longest) throw Error(ErrorCode::limit, "a ZIP archive of 4 GB or more");
    }
    const std::size_t at = out.size();
    out += directory;
    out.append(end_mark);
    append(out, 0, 2), append(out, 0, 2), append(out, files.size(), 2), append(out, files.size(), 2);
    append(out, directory.size(), 4), append(out, at, 4), append(out, 0, 2);
    return out;
}

}  // namespace cardioid::formats
