#pragma once
#include <stdexcept>
#include <string>

namespace cardioid {

/// Why a call failed; the value is the exit status of the command line.
enum class ErrorCode : int {
    unequal = 1,    ///< images differ, or `check` found faults
    usage = 2,      ///< wrong option or argument
    bad_input = 3,  ///< a file says something that cannot be understood or rendered
    io = 4,         ///< a file cannot be read or written
    limit = 5,      ///< out of memory, or over a limit
    interrupted = 130
};

/// The one exception of this project. `what()` has place, what was found, what was wanted, the nearest right name.
class Error : public std::runtime_error {
public:
    Error(ErrorCode code, const std::string& text) : std::runtime_error(text), code_(code) {}
    [[nodiscard]] ErrorCode code() const noexcept { return code_; }

private:
    ErrorCode code_;
};

}  // namespace cardioid
