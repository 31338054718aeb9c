#pragma once
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "tests/accuracy/verdict.hpp"

namespace cardioid::test {

/// What has been measured by one module, kept in a JSON file, so that a long measurement may be done in pieces. A
/// result counts as long as the scene's text, its parameters, the place and the tolerance are the same; which program
/// it was measured by is the caller's care.
class Results {
public:
    /// Reads `file` if it is there; an empty name keeps nothing. Throws Error(bad_input, io).
    explicit Results(std::string file);

    /// The result of a value, if it was sure, or took all the samples that are allowed now.
    [[nodiscard]] std::optional<Verdict> find(const KnownValue& known, const std::string& module) const;
    /// The result, however sure.
    [[nodiscard]] std::optional<Verdict> any(const KnownValue& known, const std::string& module) const;
    /// Adds a result and writes the file anew, whole or not at all.
    void add(const KnownValue& known, const std::string& module, const Verdict& verdict);

private:
    struct Kept {
        std::string of;  ///< what it was measured of, as a number
        Measured found;
    };
    void write() const;

    std::string file_;
    std::map<std::string, Kept> kept_;  ///< by module and title
    mutable std::mutex mutex_;
};

}  // namespace cardioid::test
