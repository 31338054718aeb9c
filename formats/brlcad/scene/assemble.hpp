#pragma once
#include "formats/brlcad/database.hpp"
#include "rt_core/api/format.hpp"
#include "rt_core/scene/scene.hpp"

namespace cardioid::formats::brlcad {

/// The objects that are asked for (all top objects where none is) as a scene. Throws Error(usage) where one is not
/// there or a setting is unknown, Error(bad_input) where nothing can be drawn, Error(limit).
Scene assemble(Database database, const std::string& file, const ReadOptions& options);

}  // namespace cardioid::formats::brlcad
