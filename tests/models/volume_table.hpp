#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace cardioid::test {

/// What OpenSCAD and CGAL say of a model: a row of volumes.tsv.
struct VolumeRow {
    std::string name;              ///< "examples/Old__example001.csg"
    std::optional<double> volume;  ///< of the STL it exported, 6 digits a coordinate; none where it exported nothing
    std::string message;           ///< what OpenSCAD complained of, "" if of nothing
    /// The program that the row is about; it need not be there.
    [[nodiscard]] std::filesystem::path program() const;
};

/// The rows of the file with the reference volumes, which lies beside the project; empty without it.
std::vector<VolumeRow> read_volume_table();

}  // namespace cardioid::test
