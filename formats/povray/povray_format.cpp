#include "formats/povray/povray_format.hpp"

#include <array>

#include "formats/povray/scene/scene_writer.hpp"

namespace cardioid::formats {
namespace {

constexpr std::array pov_extensions = {".pov"};

}  // namespace

const Format pov_format{
    "pov", "scene of POV-Ray 3.7 that gives the same picture", pov_extensions, nullptr, nullptr, povray::write_scene};

}  // namespace cardioid::formats
