#pragma once
#include <string>
#include <vector>

#include "photon/file/map_writer.hpp"
#include "rt_core/api/error.hpp"

namespace cardioid::photon {

/// Photons as a map file holds them.
struct PhotonSet {
    std::vector<Photon> photons;
    Vec3d origin;  ///< positions are relative to it, scene units
    float flux_scale = 1;
};

/// A map file, checked whole as it is opened: a file that is foreign, of another version or machine, truncated or
/// changed is refused with Error(bad_input) that says which; one that cannot be read with Error(io).
class MapReader {
public:
    explicit MapReader(const std::string& path);

    /// World::hash() of the scene it was made for.
    [[nodiscard]] std::uint64_t scene() const noexcept { return scene_; }
    /// Throws Error(bad_input) where the file was made for another scene.
    void require_scene(std::uint64_t scene) const;
    /// Throws Error(bad_input) naming the first line that differs between the file's section `name` and `wanted`, both
    /// of lines "option = value".
    void require_text(const std::string& name, const std::string& wanted) const;

    [[nodiscard]] bool has(const std::string& name) const { return find(name) != nullptr; }
    /// Items of a section. Throws Error(bad_input) where there is no such section of such items.
    template <class Item>
    [[nodiscard]] std::vector<Item> items(const std::string& name) const {
        static_assert(std::is_trivially_copyable_v<Item>);
        const Section& section = required(name, sizeof(Item));
        std::vector<Item> out(section.header.count);
        copy(section, std::as_writable_bytes(std::span(out)));
        return out;
    }
    [[nodiscard]] std::string text(const std::string& name) const;
    [[nodiscard]] PhotonSet photons(const std::string& name) const;

    /// What is in it, for `cardioid info`.
    struct Entry {
        std::string name;
        std::uint64_t count, bytes;
    };
    [[nodiscard]] std::vector<Entry> entries() const;

private:
    struct Section {
        std::string name;
        SectionHeader header;
        std::uint64_t at;  ///< of its items in the file
    };
    [[nodiscard]] const Section* find(const std::string& name) const;
    [[nodiscard]] const Section& required(const std::string& name, std::size_t item_bytes) const;
    void copy(const Section& section, std::span<std::byte> out) const;

    std::string path_;
    std::uint64_t scene_ = 0;
    std::vector<Section> sections_;
};

/// Whether a file begins as a map file does.
[[nodiscard]] bool is_map_file(const std::string& path);

}  // namespace cardioid::photon
