#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace cardioid::cli {

/// What is in a photon map file: the scene it belongs to, its sections, the options it was made with. Throws Error.
nlohmann::ordered_json map_json(const std::string& file);
std::string map_text(const nlohmann::ordered_json& json);

}  // namespace cardioid::cli
