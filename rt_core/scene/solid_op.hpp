#pragma once
#include <cstdint>

namespace cardioid {

enum class SolidOp : std::uint8_t {
    leaf,       ///< `first` indexes SolidTree::leaves
    unite,      ///< union of the children; empty without any
    intersect,  ///< empty without any
    subtract    ///< first child minus the rest; empty where the first is empty
};

}  // namespace cardioid
