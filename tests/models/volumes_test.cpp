#include <algorithm>
#include <chrono>
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <map>

#include "csg/compile.hpp"
#include "csg/exact/evaluate_mesh.hpp"
#include "csg/measure.hpp"
#include "csg/shapes/mesh_repair.hpp"
#include "formats/mesh/mesh_file.hpp"
#include "rt_core/api/error.hpp"
#include "tests/models/corpus.hpp"
#include "tests/models/volume_table.hpp"

// Volumes by rays against those of OpenSCAD's meshes (CGAL), everything in OpenSCAD's facets.
namespace {

using namespace cardioid;
using namespace cardioid::test;

constexpr int first_grid = 256, last_grid = 4096;  ///< lines a side
constexpr double good_share = 2e-3;                ///< standard error that is small enough, of the volume
constexpr double time_limit_s = 20;                ///< for one model

/// Rows where OpenSCAD's figure is not the volume of the model, and what is compared then.
enum class Trouble { absolute, without_reference, refused, thin };
struct KnownTrouble {
    const char* name;
    Trouble trouble;
    const char* reason;
};
constexpr std::array known_troubles{
    KnownTrouble{"testdata/scad__3D__features__polyhedron-tests.csg", Trouble::without_reference,
                 "OpenSCAD found open meshes and left them out"},
    KnownTrouble{"testdata/scad__3D__features__primitive-inf-tests.csg", Trouble::without_reference,
                 "OpenSCAD takes the inf it wrote for an unknown variable"},
    KnownTrouble{
        "testdata/scad__3D__issues__issue1089.csg", Trouble::thin,
        "a hull 7e-8 of its size thick, where rays take faces of six digits within 1e-6 for one: the volume of "
        "its exact mesh is compared"},
    KnownTrouble{"testdata/scad__3D__issues__issue1137.csg", Trouble::refused,
                 "a face of its polyhedron is a bow tie, so four edges are open; OpenSCAD refuses the sum as well"},
    KnownTrouble{"testdata/scad__3D__issues__issue964b.csg", Trouble::without_reference,
                 "its faces are bent, and the triangles they are cut into run through each other"},
    KnownTrouble{"testdata/scad__3D__issues__polygon-illegal-winding.csg", Trouble::absolute,
                 "OpenSCAD exports its faces inside out, so its volume has the wrong sign"},
};

const KnownTrouble* trouble_of(const std::string& name) {
    const auto* const found =
        std::ranges::find_if(known_troubles, [&](const KnownTrouble& known) { return name == known.name; });
    return found == known_troubles.end() ? nullptr : found;
}

/// What became of the rows.
struct Tally {
    int agree = 0, empty = 0, plane = 0, without_reference = 0;
    std::map<std::string, int> refused;  ///< by the nodes that are to come
    std::vector<double> z;               ///< (ours - theirs) / sigma
    std::vector<std::string> coarse;     ///< sigma stayed above good_share
};

struct Measured {
    csg::VolumeEstimate volume;
    int grid = 0;
    double time_s = 0;
};

/// More lines until the standard error is small enough.
Measured measure(const Scene& scene) {
    const auto start = std::chrono::steady_clock::now();
    const auto region = csg::compile_whole(scene.solids, scene.six_digits);
    Measured out;
    if (!region) return out;
    for (out.grid = first_grid;; out.grid *= 2) {
        out.volume = csg::measure_volume(*region, region->bounds(), out.grid, 1);
        out.time_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        const bool good = out.volume.sigma <= good_share * std::abs(out.volume.volume);
        // Twice the grid is four times the work.
        if (good || out.grid * 2 > last_grid || out.time_s * 5 > time_limit_s) return out;
    }
}

/// The volume of the exact mesh.
double mesh_volume(const Scene& scene) {
    double sum = 0;
    for (const std::uint32_t root : scene.solids.roots) {
        TriangleMesh mesh = csg::evaluate_mesh(scene.solids, root, 0);
        EXPECT_TRUE(csg::weld(mesh).closed());
        sum += csg::volume(mesh);
    }
    return sum;
}

/// The table was made where other fonts are installed.
bool depends_on_fonts(const VolumeRow& row) {
    const auto csg = evaluated(row.program(), ".csg");
    return csg && file_text(*csg).find("text(") != std::string::npos;
}

/// The volume of the mesh that openscad makes here.
double local_volume(const VolumeRow& row) {
    const auto stl = evaluated(row.program(), ".stl");
    if (!stl) return NAN;
    TriangleMesh mesh = formats::read_mesh(stl->string());
    csg::weld(mesh);
    return csg::volume(mesh);
}

void compare(const VolumeRow& row, const Scene& scene, Tally& tally) {
    const Measured ours = measure(scene);
    const double sigma = ours.volume.sigma, volume = ours.volume.volume;
    ASSERT_TRUE(std::isfinite(volume)) << row.name;
    const KnownTrouble* const trouble = trouble_of(row.name);
    if (trouble) fmt::print("{}: {}\n", row.name, trouble->reason);
    if (trouble && trouble->trouble == Trouble::without_reference) {
        ++tally.without_reference;
        return;
    }
    const double reference = depends_on_fonts(row) ? local_volume(row) : *row.volume;
    const double theirs = trouble ? std::abs(reference) : reference;
    if (trouble && trouble->trouble == Trouble::thin) {
        EXPECT_LE(std::abs(mesh_volume(scene) - theirs), 2e-6 * theirs) << row.name;
        EXPECT_EQ(volume, 0) << row.name;  // and never the volume of what lies behind it
        return;
    }
    EXPECT_LE(std::abs(volume - theirs), 4 * sigma + 2e-6 * theirs)
        << row.name << ": " << volume << " +- " << sigma << ", OpenSCAD has " << theirs;
    const double z = sigma > 0 ? (volume - theirs) / sigma : 0;
    fmt::print("{:<66} {:>12.6g} {:>12.6g} z {:>6.2f} sigma/V {:.1e} grid {} {:.2f} s\n", row.name, volume, theirs, z,
               theirs > 0 ? sigma / theirs : 0, ours.grid, ours.time_s);
    ++tally.agree;
    tally.z.push_back(z);
    if (sigma > good_share * theirs) tally.coarse.push_back(row.name);
}

/// Nothing of OpenSCAD's to compare with: what it said tells what the model must be.
void check_without_volume(const VolumeRow& row, const Scene& scene, Tally& tally) {
    if (row.message.find("top level object is empty") != std::string::npos) {
        EXPECT_EQ(measure(scene).volume.volume, 0) << row.name;
        ++tally.empty;
    } else if (row.message.find("not a 3D object") != std::string::npos) {
        ++tally.plane;
    } else {
        ++tally.without_reference;
    }
}

void check_row(const VolumeRow& row, Tally& tally) {
    const auto csg = evaluated(row.program(), ".csg");
    if (!csg) {
        EXPECT_FALSE(row.volume) << row.name << ": openscad does not evaluate it";
        ++tally.empty;
        return;
    }
    if (const KnownTrouble* const trouble = trouble_of(row.name); trouble && trouble->trouble == Trouble::refused) {
        EXPECT_THROW(read_evaluated(*csg, row.program()), Error) << row.name;
        fmt::print("{}: {}\n", row.name, trouble->reason);
        ++tally.without_reference;
        return;
    }
    const std::vector<std::string> missing = nodes_to_come(file_text(*csg));
    for (const std::string& node : missing) ++tally.refused[node];
    try {
        const Scene scene = read_evaluated(*csg, row.program());
        EXPECT_TRUE(missing.empty()) << row.name << " was read, though it needs " << missing[0];
        if (row.volume)
            compare(row, scene, tally);
        else
            check_without_volume(row, scene, tally);
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::bad_input) << row.name;
        EXPECT_FALSE(missing.empty()) << row.name << ": " << error.what();
    }
}

void report(const Tally& tally) {
    double sum = 0, squares = 0, largest = 0;
    for (const double z : tally.z) sum += z, squares += z * z, largest = std::max(largest, std::abs(z));
    const double n = static_cast<double>(std::max<std::size_t>(tally.z.size(), 1)), mean = sum / n;
    fmt::print(
        "{} agree: z has mean {:.2f}, deviation {:.2f}, largest {:.2f}; {} empty, {} plane, {} without reference\n",
        tally.agree, mean, std::sqrt(std::max(squares / n - mean * mean, 0.0)), largest, tally.empty, tally.plane,
        tally.without_reference);
    for (const auto& [node, count] : tally.refused) fmt::print("refused for {}: {}\n", node, count);
    for (const std::string& name : tally.coarse) fmt::print("standard error above {} of {}\n", good_share, name);
}

}  // namespace

TEST(Volumes, OfRealModelsAreOpenScads) {
    if (!has_openscad()) GTEST_SKIP() << "openscad is not installed";
    const std::vector<VolumeRow> table = read_volume_table();
    if (table.empty()) GTEST_SKIP() << "no volumes.tsv: ../shared/data/openscad is not there";
    Tally tally;
    std::size_t rows = 0;
    for (const VolumeRow& row : table) {
        if (!std::filesystem::exists(row.program())) continue;
        ++rows;
        check_row(row, tally);
    }
    if (rows == 0) GTEST_SKIP() << "none of the models is installed: apt install openscad openscad-testing-data";
    report(tally);
    if (rows < table.size())
        fmt::print("{} models are not installed (openscad-testing-data)\n", table.size() - rows);
    else
        EXPECT_GT(tally.agree, 50);
}

TEST(Volumes, AreSeenToBeTwoPercentWrong) {
    const std::filesystem::path program = openscad_share / "examples/Old/example003.scad";
    if (!has_openscad() || !std::filesystem::exists(program)) GTEST_SKIP() << "openscad is not installed";
    const csg::VolumeEstimate ours = measure(read_evaluated(*evaluated(program, ".csg"), program)).volume;
    EXPECT_NEAR(ours.volume, 23750, 4 * ours.sigma);
    EXPECT_GT(std::abs(ours.volume - 1.02 * 23750), 4 * ours.sigma);
}
