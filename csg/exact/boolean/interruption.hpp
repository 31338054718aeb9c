#pragma once
#include "rt_core/api/error.hpp"
#include "rt_core/api/progress.hpp"

namespace cardioid::csg {

/// While it lives, check() on the same thread looks whether the user wants to stop.
class Interruption {
public:
    explicit Interruption(const Progress* progress) : before_(watched) { watched = progress; }
    ~Interruption() { watched = before_; }
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    /// Throws Error(interrupted) where that is wanted.
    static void check() {
        if (watched && watched->interrupted())
            throw Error(ErrorCode::interrupted, "interrupted while solids were evaluated; nothing is saved");
    }

private:
    static inline thread_local const Progress* watched = nullptr;
    const Progress* before_;
};

}  // namespace cardioid::csg
