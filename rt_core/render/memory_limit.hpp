#pragma once
#include <string>

namespace cardioid {

/// Throws Error(limit) naming `what` and the bytes where the machine has fewer than `bytes` to give now.
void require_memory(double bytes, const std::string& what);

}  // namespace cardioid
