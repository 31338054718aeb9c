#pragma once
#include <cstdint>
#include <map>
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
    /// Of the long run by each module, or by all under ""; relative, absolute where 0 is expected.
    std::map<std::string, double> tolerances;
    std::string source;
    std::string formula;  ///< that gives `expected` anew, a name of known_formula()
    std::vector<double> args;
    double times = 1;                  ///< what the formula is multiplied by
    std::vector<std::string> modules;  ///< of lighting that can find it; empty: all
    bool heavy = false;                ///< too noisy for the short run by path
    std::vector<std::string> also;     ///< other modules whose short run has it

    [[nodiscard]] double tolerance(const std::string& module) const;
    [[nodiscard]] bool applies_to(const std::string& module) const;
    [[nodiscard]] bool in_short_run(const std::string& module) const;
    [[nodiscard]] bool same_setting(const KnownValue& other) const;
    /// "A3b: rooms/plates.csg, rho 0.5, 0.5, upper".
    [[nodiscard]] std::string title() const;
};

/// The whole table, read once. Throws Error(bad_input, io) with the place that is wrong.
const std::vector<KnownValue>& known_values();

/// Values of one scene with the same parameters.
using Setting = std::vector<KnownValue>;

/// Which values a run has.
enum class Run { quick, whole };

/// Those that a module can find, in the order of the table.
std::vector<Setting> known_settings(const std::string& module, Run run);

/// A name that CTest and GoogleTest accept: letters, digits and "_".
std::string plain_name(const std::string& title);

}  // namespace cardioid::test
