#include "photon/file/map_writer.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fmt/format.h>
#include <unistd.h>

#include "rt_core/api/error.hpp"

namespace cardioid::photon {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& path) {
    throw Error(ErrorCode::io, fmt::format("{}: cannot write the map: {}", path, std::strerror(errno)));
}

}  // namespace

MapWriter::MapWriter(std::string path, std::uint64_t scene)
    : path_(std::move(path)), temporary_(fmt::format("{}.{}.tmp", path_, ::getpid())) {
    if (fs::is_directory(path_)) {
        errno = EISDIR;
        fail(path_);
    }
    file_.open(temporary_, std::ios::binary | std::ios::trunc);
    if (!file_) fail(path_);
    FileHeader header;
    header.scene = scene;
    Checksum checksum;
    checksum.add(std::as_bytes(std::span(&header, 1)).first(offsetof(FileHeader, checksum)));
    header.checksum = checksum.value();
    write(std::as_bytes(std::span(&header, 1)));
}

MapWriter::~MapWriter() {
    if (finished_) return;
    file_.close();
    std::error_code ignored;
    fs::remove(temporary_, ignored);
}

void MapWriter::write(std::span<const std::byte> bytes) {
    file_.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    if (!file_) fail(path_);
}

void MapWriter::add_bytes(const std::string& name, std::size_t item_bytes, std::size_t count,
                          std::span<const std::byte> bytes) {
    SectionHeader header;
    std::copy_n(name.begin(), std::min(name.size(), header.name.size() - 1), header.name.begin());
    header.item_bytes = item_bytes;
    header.count = count;
    Checksum checksum;
    checksum.add(std::as_bytes(std::span(&header, 1)));
    checksum.add(bytes);
    const std::uint64_t sum = checksum.value();
    write(std::as_bytes(std::span(&header, 1)));
    write(bytes);
    write(std::as_bytes(std::span(&sum, 1)));
}

void MapWriter::add_photons(const std::string& name, std::span<const Photon> photons, Vec3d origin, float flux_scale) {
    const PhotonFrame frame{origin, double{flux_scale}};
    add(name + ".frame", std::span(&frame, 1));
    add(name, photons);
}

void MapWriter::finish() {
    add_bytes(end_section, 0, 0, {});
    file_.close();
    if (!file_) fail(path_);
    std::error_code error;
    fs::rename(temporary_, path_, error);
    if (error) {
        errno = error.value();
        fail(path_);
    }
    finished_ = true;
}

}  // namespace cardioid::photon
