#pragma once
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "tests/accuracy/place.hpp"

namespace cardioid::test {

/// A value of samples/accuracy/expected.json: what a scene with a known answer must show at a place.
struct KnownValue {
    std::string section;  ///< of the list of anchors: "A3b"
    std::string name;
    std::string scene;  ///< file in samples/accuracy
    /// Texts of the scene and what stands in their place: its parameters.
    std::vector<std::pair<std::string, std::string>> change;
    Place place;
    double expected = 0;
    double tolerance = 0;  ///< of the long run, relative; absolute where 0 is expected
    std::string source;
    std::string formula;  ///< that gives `expected` anew, a name of known_formula()
    std::vector<double> args;
    double times = 1;                  ///< what the formula is multiplied by
    std::vector<std::string> modules;  ///< of lighting that can find it; empty: all
    bool heavy = false;                ///< too noisy for the short run

    [[nodiscard]] bool applies_to(const std::string& module) const;
    /// "A3b: rooms/plates.csg, rho 0.5, 0.5, upper".
    [[nodiscard]] std::string title() const;
};

/// The whole table, read once. Throws Error(bad_input, io) with the place that is wrong.
const std::vector<KnownValue>& known_values();

/// Those that a module can find, without the heavy ones unless `all`.
std::vector<KnownValue> known_values(const std::string& module, bool all);

/// A name that CTest and GoogleTest accept: letters, digits and "_".
std::string plain_name(const std::string& title);

}  // namespace cardioid::test
