#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace cardioid::formats::brlcad {

/// A matrix of a database, by rows: x' = (M x) / (m12 x + m13 y + m14 z + m15).
using Matrix = std::array<double, 16>;

/// One step of a combination's tree in postfix order: a member, or what is done with what stands before it.
struct Step {
    enum class Op : std::uint8_t { member, unite, intersect, subtract, exclusive, complement };
    Op op = Op::member;
    std::string name{};              ///< of a member
    std::optional<Matrix> matrix{};  ///< of a member; nothing: the identity
};

using Colour8 = std::array<std::uint8_t, 3>;

struct Combination {
    std::vector<Step> steps;  ///< postfix, checked to leave one value; empty: no members
    bool region = false;
    int region_id = 0, air_code = 0;
    std::optional<Colour8> colour;
    std::string shader;                                     ///< "plastic {sh 10}" or "plastic sh=10"; empty: none
    bool standard_colour = false, standard_shader = false;  ///< from the key that wins: color, oshader
    bool inherit = false;                                   ///< colour and shader win over those of lower combinations
};

/// Solids by BRL-CAD's names.
enum class SolidKind : std::uint8_t {
    tor,
    tgc,
    ell,
    arb8,
    half,
    part,
    rpc,
    rhc,
    epa,
    ehy,
    eto,
    hyp,
    superell,
    pipe,
    arbn,
    bot,
    sketch,
    extrude,
    revolve,
    ars,
    dsp,
    ebm,
    vol,
    hf,
    metaball,
    cline,
    data,     ///< numbers that other solids use: no solid
    nothing,  ///< what rt draws nothing of either: grip, joint, pnts, constraints ...
    unsupported
};

/// A piece of a sketch's outline, between its corners.
struct SketchCurve {
    enum class Kind : std::uint8_t { line, arc, bezier, nurb } kind = Kind::line;
    std::vector<std::uint32_t> corners{};  ///< both ends, or all that a Bezier curve or a NURB has
    double radius = 0;                     ///< of an arc [mm]; negative: a circle about the second through the first
    bool centre_left = false;              ///< of an arc: seen from the first corner to the second
    bool clockwise = false;                ///< of an arc
    std::vector<double> knots{};           ///< of a NURB: as many as corners and order
    std::vector<double> weights{};         ///< of a NURB: one a corner, or none where all are 1
};

/// A primitive. `numbers` as in the binary format, lengths in mm; see solid_kinds.hpp for their order. A pipe has
/// x y z, inner and outer diameter, bend radius a point; an arbn n and d a plane; a bot the corners; a sketch origin,
/// both axes and its corners; an extrude origin, height and the axes of its sketch; a revolve origin, axis, start and
/// angle; an ars its points, curve by curve; a metaball its threshold, then x y z, strength and sharpness a point.
struct Solid {
    SolidKind kind = SolidKind::unsupported;
    std::vector<double> numbers;
    std::vector<std::uint32_t> corners;           ///< of a bot's triangles
    int mode = 2;                                 ///< of a bot: 1 surface, 2 solid, 3 and 4 plates
    int orientation = 1;                          ///< of a bot: 1 none, 2 counter-clockwise, 3 clockwise
    std::vector<double> thickness;                ///< of a bot's triangles where it is a plate [mm]
    std::vector<bool> appended{};                 ///< of a bot's plates: the triangle is a face, else the middle
    std::string type;                             ///< BRL-CAD's name of the type, for messages
    std::string sketch{};                         ///< name of the sketch that is extruded or turned
    std::vector<SketchCurve> curves{};            ///< of a sketch
    std::size_t points_a_curve = 0;               ///< of an ars
    int method = 0;                               ///< of a metaball: 0 to 2, see FormKind::metaball
    std::map<std::string, std::string> fields{};  ///< of dsp, ebm, vol and hf: what BRL-CAD's text form calls them
    std::string bytes{};                          ///< of data, big-endian
    int element = 0;                              ///< of data: BRL-CAD's number of their type
};

struct Object {
    std::string name;
    std::string place;  ///< "file:line:column" or "file:offset", for messages
    std::optional<Combination> combination;
    Solid solid;  ///< where it is no combination
};

/// Regions whose number lies in [low, high] have this colour where no combination says otherwise.
struct ColourRange {
    long low = 0, high = 0;
    Colour8 colour{};
};

/// All that a database says, whichever form it was read from.
struct Database {
    std::string title;
    double unit_mm = 1;  ///< the editor's unit; lengths are in mm whatever it is
    std::vector<Object> objects;
    std::unordered_map<std::string, std::size_t> index;  ///< of objects by name
    std::vector<ColourRange> colours;
    std::vector<std::string> warnings;
    std::string folder;  ///< where files that solids name are

    /// Adds an object; one of the same name is replaced.
    void add(Object object);
    [[nodiscard]] const Object* find(const std::string& name) const;
};

/// Sets what an attribute of a combination says: region, region_id, color, rgb, shader, oshader, inherit, aircode ...;
/// others mean nothing to a picture.
void set_attribute(Combination& combination, const std::string& key, const std::string& value);
/// Sets an attribute of the whole database: title, units, regionid_colortable.
void set_global(Database& database, const std::string& key, const std::string& value);

/// Whether postfix steps leave exactly one value, and never take more than there are.
bool well_formed(const std::vector<Step>& steps);

/// mm in a unit of that name ("in", "ft", "m" ...) or a number as text; 1 for what is not known.
double unit_mm(const std::string& unit);
/// Its name, else its length: "25.4 mm".
std::string unit_name(double mm);

}  // namespace cardioid::formats::brlcad
