#pragma once
#include <string>
#include <utility>
#include <vector>

#include "formats/brlcad/database.hpp"

namespace cardioid::formats::brlcad {

/// What BRL-CAD's `title`, `units`, `tops` and `summary` tell of a database, for `cardioid info`: names and texts, in
/// the order they are shown. `tops` are the objects that no combination has.
std::vector<std::pair<std::string, std::string>> facts_of(const Database& database,
                                                          const std::vector<std::string>& tops);

}  // namespace cardioid::formats::brlcad
