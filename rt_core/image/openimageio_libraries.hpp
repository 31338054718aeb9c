#pragma once

namespace cardioid {

/// What OpenImageIO needs, each after what it needs itself, null at the end: see cmake/openimageio_libraries.cmake.
extern const char* const openimageio_libraries[];

}  // namespace cardioid
