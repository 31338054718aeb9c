#pragma once
#include <string>

#include "rt_core/api/image.hpp"
#include "rt_core/image/film.hpp"

namespace cardioid {

struct ImageWriteSettings {
    double exposure = 0;  ///< EV, for the 8-bit formats
    bool half = false;    ///< OpenEXR in half precision instead of float
    Metadata metadata;
};

/// Throws Error(usage) now rather than after the render where the extension of `path` is none OpenImageIO writes
/// (with the nearest right one), and Error(io) where its folder is missing or cannot be written. The picture formats
/// are being loaded from here on, beside whatever is done meanwhile.
void check_image_path(const std::string& path);

/// Waits until the picture formats are loaded. Throws Error(io) where they are not installed.
void check_image_formats();

/// Writes by extension: PNG, JPEG and other 8-bit formats sRGB-encoded, EXR and the like linear with every layer
/// as channels ("direct.R"); extra layers of an 8-bit picture go to files beside it ("out.direct.png").
/// The file appears whole or not at all. Throws Error(io).
void write_image(const std::string& path, const Film& film, const ImageWriteSettings& settings);

/// Every channel of the first subimage as floats, 8-bit pictures left encoded as they are, with the metadata and
/// whether it is encoded. Throws Error(io).
Film read_image(const std::string& path, Metadata* metadata = nullptr, bool* encoded = nullptr);

}  // namespace cardioid
