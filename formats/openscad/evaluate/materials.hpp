#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

#include "formats/openscad/evaluate/colours.hpp"
#include "rt_core/api/registry.hpp"
#include "rt_core/scene/scene.hpp"

namespace cardioid::formats::openscad {

/// The material of everything that names none: light grey, matt. A scene may define its own "default".
MaterialSettings default_material();

/// Scene::materials while a file is read: a name may be used before it is defined, colours become materials, and
/// map_color() may turn those into others. Index 0 is the default.
class MaterialTable {
public:
    /// registry: the kinds there are; null: kinds are not checked.
    MaterialTable(const Registry* registry, Warnings& warnings);

    /// define_material("name", kind = "...", ...). Throws Error(bad_input) for an unknown kind.
    void define(const Ast& ast, const Call& call);
    /// The index of a name, whether or not it is defined yet.
    std::uint32_t named(const std::string& name, const std::string& where);
    /// A matt material of that colour; below full opacity a coloured filter.
    std::uint32_t coloured(const Rgba& colour);
    /// The grey glass-free transparency in which `%` is drawn.
    std::uint32_t backdrop();
    void map_colour(const Rgba& colour, const std::string& material, const std::string& where);
    /// Hands the materials over and applies map_color() to the leaves. Throws Error(bad_input) for a material that was
    /// used and never defined.
    void finish(Scene& scene);

private:
    using ColourKey = std::array<std::int32_t, 4>;
    static ColourKey key(const Rgba& colour);
    void check_kind(const MaterialSettings& material, Warnings& warnings) const;
    std::uint32_t add(MaterialSettings material, std::string first_used);

    const Registry* registry_;
    Warnings& warnings_;
    std::vector<MaterialSettings> materials_;
    std::vector<std::string> first_used_;  ///< where, of each material; empty once it is defined
    std::unordered_map<std::string, std::uint32_t> by_name_;
    std::map<ColourKey, std::uint32_t> by_colour_;
    struct Mapped {
        std::uint32_t material;
        std::string where;
    };
    void warn_of_unused(const ColourKey& colour, const std::string& where) const;

    std::map<ColourKey, Mapped> mapped_;
};

}  // namespace cardioid::formats::openscad
