#include "csg/exact/mesh_cache.hpp"

#include <algorithm>
#include <atomic>
#include <bit>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <unistd.h>

#include "rt_core/math/sampler.hpp"

namespace cardioid::csg {

namespace {

namespace fs = std::filesystem;

/// Changed whenever the same input may give another mesh.
constexpr std::uint64_t format_number = 4;
constexpr std::uintmax_t most_bytes = std::uintmax_t{256} << 20;

/// The folder, or nothing where there is no place for one.
std::optional<fs::path> folder() {
    const char* const wish = std::getenv("CARDIOID_CACHE");
    if (wish && std::string_view(wish) == "0") return std::nullopt;
    const char* const xdg = std::getenv("XDG_CACHE_HOME");
    const char* const home = std::getenv("HOME");
    fs::path out;
    if (xdg && *xdg == '/')
        out = fs::path(xdg) / "cardioid";
    else if (home && *home == '/')
        out = fs::path(home) / ".cache" / "cardioid";
    else
        return std::nullopt;
    std::error_code failed;
    fs::create_directories(out, failed);
    if (failed) return std::nullopt;
    return out;
}

template <class T>
void append(std::string& out, const std::vector<T>& values) {
    const auto count = static_cast<std::uint64_t>(values.size());
    out.append(reinterpret_cast<const char*>(&count), sizeof count);
    out.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

template <class T>
bool take(std::string_view& from, std::vector<T>& values) {
    std::uint64_t count = 0;
    if (from.size() < sizeof count) return false;
    std::copy_n(from.data(), sizeof count, reinterpret_cast<char*>(&count));
    from.remove_prefix(sizeof count);
    if (count > from.size() / sizeof(T)) return false;
    values.resize(count);
    std::copy_n(from.data(), count * sizeof(T), reinterpret_cast<char*>(values.data()));
    from.remove_prefix(count * sizeof(T));
    return true;
}

std::uint64_t checksum(std::string_view bytes) {
    std::uint64_t out = format_number;
    for (const char c : bytes) out = (out ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
    return out;
}

std::string packed(const std::vector<TriangleMesh>& meshes) {
    std::string body;
    for (const TriangleMesh& mesh : meshes) {
        body += mesh.closed ? '\1' : '\0';
        append(body, mesh.vertices);
        append(body, mesh.triangles);
    }
    const std::uint64_t sum = checksum(body);
    return std::string(reinterpret_cast<const char*>(&sum), sizeof sum) + body;
}

std::optional<std::vector<TriangleMesh>> unpacked(std::string_view bytes) {
    std::uint64_t sum = 0;
    if (bytes.size() < sizeof sum) return std::nullopt;
    std::copy_n(bytes.data(), sizeof sum, reinterpret_cast<char*>(&sum));
    bytes.remove_prefix(sizeof sum);
    if (checksum(bytes) != sum) return std::nullopt;
    std::vector<TriangleMesh> out;
    while (!bytes.empty()) {
        TriangleMesh& mesh = out.emplace_back();
        mesh.closed = bytes[0] != 0;
        bytes.remove_prefix(1);
        if (!take(bytes, mesh.vertices) || !take(bytes, mesh.triangles)) return std::nullopt;
    }
    return out;
}

std::optional<std::vector<TriangleMesh>> find(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in) return std::nullopt;
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    auto out = unpacked(bytes);
    std::error_code ignored;
    if (out) fs::last_write_time(file, fs::file_time_type::clock::now(), ignored);  // used just now
    return out;
}

/// Removes the least recently used files until `more` bytes fit.
void make_room(const fs::path& in, std::uintmax_t more) {
    struct Kept {
        fs::file_time_type used;
        fs::path path;
        std::uintmax_t bytes;
    };
    std::vector<Kept> files;
    std::error_code failed;
    std::uintmax_t sum = more;
    for (fs::directory_iterator at(in, failed), end; !failed && at != end; at.increment(failed)) {
        std::error_code gone;  // another process may have removed it
        const Kept file{at->last_write_time(gone), at->path(), at->file_size(gone)};
        if (gone) continue;
        sum += file.bytes;
        files.push_back(file);
    }
    std::ranges::sort(files, {}, &Kept::used);
    for (const Kept& file : files) {
        if (sum <= most_bytes) return;
        fs::remove(file.path, failed);
        sum -= file.bytes;
    }
}

void keep(const fs::path& in, const std::string& name, const std::string& bytes) {
    if (bytes.size() > most_bytes / 4) return;
    static std::atomic<unsigned> number{0};  // two threads may make the same
    make_room(in, bytes.size());
    const fs::path fresh = in / (name + "." + std::to_string(getpid()) + "." + std::to_string(number++));
    std::error_code ignored;
    std::ofstream out(fresh, std::ios::binary);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    out.close();
    if (out)
        fs::rename(fresh, in / name, ignored);  // the file appears whole
    else
        fs::remove(fresh, ignored);
}

}  // namespace

void ContentHash::add(std::uint64_t value) {
    a_ = mix64(a_ ^ value);
    b_ = mix64(b_ + 0x9E3779B97F4A7C15U * (value + 1));
}

void ContentHash::add(double value) { add(std::bit_cast<std::uint64_t>(value)); }

void ContentHash::add(const TriangleMesh& mesh) {
    add(static_cast<std::uint64_t>(mesh.vertices.size()));
    for (const Vec3d v : mesh.vertices) add(v.x), add(v.y), add(v.z);
    add(static_cast<std::uint64_t>(mesh.triangles.size()));
    for (const auto& [x, y, z] : mesh.triangles) add(std::uint64_t{x} << 32 | y), add(std::uint64_t{z});
}

std::string ContentHash::text() const {
    char out[33];
    std::snprintf(out, sizeof out, "%016llx%016llx", static_cast<unsigned long long>(a_),
                  static_cast<unsigned long long>(b_ ^ format_number));
    return out;
}

std::vector<TriangleMesh> cached(const ContentHash& key, const std::function<std::vector<TriangleMesh>()>& make,
                                 double worth_keeping_s) {
    const std::optional<fs::path> in = folder();
    if (in)
        if (auto found = find(*in / key.text())) return std::move(*found);
    const auto start = std::chrono::steady_clock::now();
    std::vector<TriangleMesh> out = make();
    const double took_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (in && took_s > worth_keeping_s) keep(*in, key.text(), packed(out));
    return out;
}

}  // namespace cardioid::csg
