#pragma once
#include <fstream>
#include <string>
#include <type_traits>

#include "photon/file/map_format.hpp"
#include "photon/map/photon.hpp"

namespace cardioid::photon {

/// Writes a map file whole or not at all: into a temporary file beside it that finish() renames over it. All functions
/// throw Error(io) where the disk refuses.
class MapWriter {
public:
    /// scene: World::hash().
    MapWriter(std::string path, std::uint64_t scene);
    /// Removes what was not finished.
    ~MapWriter();
    MapWriter(const MapWriter&) = delete;
    MapWriter& operator=(const MapWriter&) = delete;

    /// A section of items; `name` has at most 23 letters and is used once.
    template <class Item>
    void add(const std::string& name, std::span<const Item> items) {
        static_assert(std::is_trivially_copyable_v<Item>);
        add_bytes(name, sizeof(Item), items.size(), std::as_bytes(items));
    }
    void add_text(const std::string& name, const std::string& text) { add(name, std::span<const char>(text)); }
    /// Photons with what it takes to understand them: two sections.
    void add_photons(const std::string& name, std::span<const Photon> photons, Vec3d origin, float flux_scale);
    /// The file is complete and takes its name.
    void finish();

private:
    void add_bytes(const std::string& name, std::size_t item_bytes, std::size_t count,
                   std::span<const std::byte> bytes);
    void write(std::span<const std::byte> bytes);

    std::string path_, temporary_;
    std::ofstream file_;
    bool finished_ = false;
};

/// How photons of a map file are to be read.
struct PhotonFrame {
    Vec3d origin;  ///< positions are relative to it, scene units
    double flux_scale = 1;
};

}  // namespace cardioid::photon
