#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "rt_core/math/vec.hpp"

namespace cardioid::formats {

/// The parts of a glTF file: a GLB has both in one.
struct GltfParts {
    std::string_view json, binary;
};
GltfParts split_gltf(std::string_view bytes, const std::string& file);

/// The buffers of a glTF, from the file itself, from data within the JSON or from files beside it. Throws
/// Error(bad_input) for what is not there, Error(io) for a file that cannot be read.
class GltfBuffers {
public:
    GltfBuffers(const nlohmann::json& root, std::string_view binary, const std::string& file);
    [[nodiscard]] std::vector<Vec3d> vectors(std::size_t accessor) const;
    [[nodiscard]] std::vector<std::uint32_t> indices(std::size_t accessor) const;

private:
    /// An accessor's elements of `width` bytes each, one after another.
    [[nodiscard]] std::string elements(const nlohmann::json& accessor, std::size_t width) const;

    const nlohmann::json& root_;
    const std::string& file_;
    std::vector<std::string> buffers_;
};

}  // namespace cardioid::formats
