#include "photon/file/map_reader.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fmt/format.h>

namespace cardioid::photon {

namespace {

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
    throw Error(ErrorCode::bad_input, path + ": this map is refused: " + why);
}

[[noreturn]] void unreadable(const std::string& path) {
    throw Error(ErrorCode::io, fmt::format("{}: cannot read the map: {}", path, std::strerror(errno)));
}

bool get(std::istream& file, std::span<std::byte> bytes) {
    file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    return static_cast<std::size_t>(file.gcount()) == bytes.size();
}

template <class Item>
bool get(std::istream& file, Item& item) {
    return get(file, std::as_writable_bytes(std::span(&item, 1)));
}

/// Checksum of a section, read piece by piece.
std::uint64_t checksum_of(std::istream& file, const std::string& path, const SectionHeader& header) {
    Checksum sum;
    sum.add(std::as_bytes(std::span(&header, 1)));
    sum.begin(header.item_bytes * header.count);
    constexpr std::uint64_t piece = 1 << 20;
    std::vector<std::byte> buffer(piece);
    for (std::uint64_t left = header.item_bytes * header.count; left > 0;) {
        const auto bytes = std::span(buffer).first(std::min(left, piece));
        if (!get(file, bytes)) refuse(path, "it is truncated");
        sum.add_words(bytes);
        left -= bytes.size();
    }
    return sum.value();
}

/// Lines of "option = value".
std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        lines.push_back(text.substr(at, end - at));
        at = end + 1;
    }
    return lines;
}

FileHeader read_header(std::istream& file, const std::string& path) {
    FileHeader header;
    if (!get(file, header.magic) || header.magic != file_magic) refuse(path, "it is no map file of Cardioid");
    if (!get(file, std::as_writable_bytes(std::span(&header, 1)).subspan(sizeof(header.magic))))
        refuse(path, "it is truncated");
    if (header.order != byte_order) refuse(path, "it was written by a machine of another byte order");
    if (header.version != file_version)
        refuse(path, fmt::format("it has version {}, wanted {}", header.version, file_version));
    Checksum sum;
    sum.add(std::as_bytes(std::span(&header, 1)).first(offsetof(FileHeader, checksum)));
    if (sum.value() != header.checksum) refuse(path, "its header is damaged");
    return header;
}

}  // namespace

MapReader::MapReader(const std::string& path) : path_(path) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) errno = EISDIR, unreadable(path);
    std::ifstream file(path, std::ios::binary);
    if (!file) unreadable(path);
    file.seekg(0, std::ios::end);
    const auto size = static_cast<std::uint64_t>(std::max<std::streamoff>(file.tellg(), 0));
    file.seekg(0);
    scene_ = read_header(file, path).scene;
    for (;;) {
        Section section;
        SectionHeader& header = section.header;
        if (!get(file, header)) refuse(path, "it is truncated");
        header.name.back() = 0;
        section.name = header.name.data();
        section.at = static_cast<std::uint64_t>(file.tellg());
        if (header.item_bytes > 0 && header.count > (size - section.at) / header.item_bytes)
            refuse(path, "it is truncated");
        const std::uint64_t sum = checksum_of(file, path, header);
        std::uint64_t stored = 0;
        if (!get(file, stored)) refuse(path, "it is truncated");
        if (stored != sum) refuse(path, fmt::format("its section \"{}\" is damaged", section.name));
        if (section.name == end_section) return;
        sections_.push_back(std::move(section));
    }
}

void MapReader::require_scene(std::uint64_t scene) const {
    if (scene != scene_) refuse(path_, "it was made for another scene, or this one has changed since");
}

void MapReader::require_text(const std::string& name, const std::string& wanted) const {
    const std::string found = text(name);
    if (found == wanted) return;
    const std::vector<std::string> has = lines_of(found), wants = lines_of(wanted);
    for (std::size_t i = 0; i < std::min(has.size(), wants.size()); ++i)
        if (has[i] != wants[i]) refuse(path_, fmt::format("it was made with {}, this is {}", has[i], wants[i]));
    refuse(path_, "it was made with other options");
}

const MapReader::Section* MapReader::find(const std::string& name) const {
    const auto found =
        std::find_if(sections_.begin(), sections_.end(), [&](const Section& s) { return s.name == name; });
    return found == sections_.end() ? nullptr : &*found;
}

const MapReader::Section& MapReader::required(const std::string& name, std::size_t item_bytes) const {
    const Section* section = find(name);
    if (!section) refuse(path_, fmt::format("it has no section \"{}\"", name));
    if (section->header.item_bytes != item_bytes)
        refuse(path_, fmt::format("section \"{}\" has items of {} bytes, wanted {}", name, section->header.item_bytes,
                                  item_bytes));
    return *section;
}

void MapReader::copy(const Section& section, std::span<std::byte> out) const {
    std::ifstream file(path_, std::ios::binary);
    file.seekg(static_cast<std::streamoff>(section.at));
    if (!file || !get(file, out)) unreadable(path_);
}

std::string MapReader::text(const std::string& name) const {
    const std::vector<char> letters = items<char>(name);
    return {letters.begin(), letters.end()};
}

PhotonSet MapReader::photons(const std::string& name) const {
    const std::vector<PhotonFrame> frame = items<PhotonFrame>(name + ".frame");
    if (frame.size() != 1) refuse(path_, fmt::format("section \"{}\" is not one frame", name + ".frame"));
    return {items<Photon>(name), frame[0].origin, static_cast<float>(frame[0].flux_scale)};
}

std::vector<MapReader::Entry> MapReader::entries() const {
    std::vector<Entry> out;
    for (const Section& s : sections_) out.push_back({s.name, s.header.count, s.header.count * s.header.item_bytes});
    return out;
}

bool is_map_file(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::array<char, 8> magic{};
    return get(file, magic) && magic == file_magic;
}

}  // namespace cardioid::photon
