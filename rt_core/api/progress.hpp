#pragma once
#include <string_view>

namespace cardioid {

/// Where long work tells how far it is and asks whether it should stop. Any thread may call it.
class Progress {
public:
    virtual ~Progress() = default;
    /// A new phase begins: "photons", "cache", "render".
    virtual void begin(std::string_view /*phase*/) {}
    /// share in [0, 1] of the current phase.
    virtual void update(double /*share*/) {}
    /// True once the user wants to stop; work should return soon with what there is.
    [[nodiscard]] virtual bool interrupted() const noexcept { return false; }
    /// A line for the log; level 0 is a warning, 1 is shown with -v.
    virtual void log(int /*level*/, std::string_view /*text*/) {}
};

}  // namespace cardioid
