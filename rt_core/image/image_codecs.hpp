#pragma once
#include "rt_core/api/image.hpp"

namespace cardioid {

/// What OpenImageIO does for us. Its 250 shared libraries take 0.15 s of every start, more than many pictures, so it is
/// in a module of its own that is loaded when it is first asked. Both say what went wrong, "" for nothing; neither
/// throws but std::bad_alloc.
struct ImageCodecs {
    /// Does not read the values where there are more than most_pixels.
    std::string (*read)(const std::string& path, std::int64_t most_pixels, RawImage& image);
    /// The bytes of a file of that name's format: 8 bits a channel where image.encoded, else floats or halves.
    std::string (*encode)(const std::string& path, const RawImage& image, std::vector<unsigned char>& bytes);
};

/// Loads the module on a thread of its own, unless it is loaded or being loaded: reading a scene hides the time. What
/// goes wrong is told by image_codecs(). The process ends no sooner than the loading. Any thread may call.
void begin_loading_image_codecs();

/// The module's, which this waits for. Throws Error(io) where it is not installed. Any thread may call.
const ImageCodecs& image_codecs();

/// Name of the function by which the module gives its ImageCodecs.
constexpr const char* image_codecs_function = "cardioid_image_codecs";

}  // namespace cardioid
