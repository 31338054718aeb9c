#include "rt_core/image/image_codecs.hpp"

#include <dlfcn.h>
#include <fmt/format.h>
#include <future>
#include <system_error>

#include "rt_core/api/error.hpp"
#include "rt_core/image/openimageio_libraries.hpp"

namespace cardioid {
namespace {

/// Looked for where the program's RUNPATH says: beside the build, or in the installed lib/cardioid.
constexpr const char* module_file = "cardioid_images.so";

const ImageCodecs* load() {
    // One that is missing, or does not load without the others, comes with the module, which tells what is wrong.
    for (const char* const* library = openimageio_libraries; *library; ++library)
        dlopen(*library, RTLD_LAZY | RTLD_LOCAL);
    dlerror();
    void* const object = dlopen(module_file, RTLD_LAZY | RTLD_LOCAL);
    if (!object) throw Error(ErrorCode::io, fmt::format("cannot load the picture formats: {}", dlerror()));
    const auto codecs = reinterpret_cast<const ImageCodecs* (*)()>(dlsym(object, image_codecs_function));
    if (!codecs) throw Error(ErrorCode::io, fmt::format("{} has no {}", module_file, image_codecs_function));
    return codecs();
}

/// At once on a thread where there may be one more, else when it is asked for.
std::shared_future<const ImageCodecs*> begin() {
    try {
        return std::async(std::launch::async, load).share();
    } catch (const std::system_error&) {
        return std::async(std::launch::deferred, load).share();
    }
}

/// A copy of its own for each caller: only so may threads wait for it together.
std::shared_future<const ImageCodecs*> loading() {
    static const std::shared_future<const ImageCodecs*> result = begin();
    return result;
}

}  // namespace

void begin_loading_image_codecs() { static_cast<void>(loading()); }

const ImageCodecs& image_codecs() { return *loading().get(); }

RawImage read_raw_image(const std::string& path, std::int64_t most_pixels) {
    RawImage image;
    const std::string failure = image_codecs().read(path, most_pixels, image);
    if (!failure.empty()) throw Error(ErrorCode::io, fmt::format("{}: cannot read: {}", path, failure));
    if (std::int64_t{image.width} * image.height > most_pixels)
        throw Error(ErrorCode::limit,
                    fmt::format("{}: {}x{} pixels, wanted at most {}", path, image.width, image.height, most_pixels));
    return image;
}

}  // namespace cardioid
