#pragma once
#include <optional>
#include <string>
#include <vector>

#include "formats/brlcad/database.hpp"
#include "rt_core/scene/solid.hpp"

namespace cardioid::formats::brlcad {

/// What a region looks like: what the combinations above it and it itself say (db_apply_state_from_comb).
struct RegionLook {
    std::optional<Colour8> colour;  ///< nothing: white
    std::string shader;
    int region_id = 0;
    bool operator==(const RegionLook&) const = default;
};

/// A region of the model: a solid of one look.
struct Region {
    std::string path;  ///< "/all.g/box.r"
    RegionLook look;
    std::uint32_t material = 0;
    std::uint32_t node = 0;  ///< of the solid
};

/// Who gives surfaces to what the combinations name.
class Surfaces {
public:
    virtual ~Surfaces() = default;
    /// The material of a region; asked once for each, before its leaves are made.
    virtual std::uint32_t of_region(const RegionLook& look) = 0;
    /// That of one solid of it, given the region's.
    virtual std::uint32_t of_solid(std::uint32_t material, const Solid& solid, const Affine& place) = 0;
};

/// Follows the combinations below the named objects down to solids; what they say wrong or what is not supported is a
/// warning, once for each object. Throws
/// Error(limit) where combinations multiply past ten million members.
std::vector<Region> collect_regions(const Database& database, const std::vector<std::string>& objects,
                                    Surfaces& surfaces, SolidTree& tree, std::vector<std::string>& warnings);

/// Objects that no combination has as a member, in the order of their names.
std::vector<std::string> top_objects(const Database& database);

}  // namespace cardioid::formats::brlcad
