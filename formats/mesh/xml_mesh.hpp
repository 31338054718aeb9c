#pragma once
#include <pugixml.hpp>

#include "formats/mesh/readers.hpp"
#include "rt_core/math/affine.hpp"

namespace cardioid::formats {

/// Parses XML; throws Error(bad_input) with file:line.
void parse_xml(std::string_view text, const std::string& file, pugi::xml_document& out);

/// A number of an XML mesh; throws Error(bad_input) where it is none.
double xml_number(const char* text, const std::string& file, const char* wanted);

/// Adds vertices and triangles, placed by `map`. Throws Error(bad_input) for a corner that is not there.
void add_part(const std::vector<Vec3d>& vertices, const std::vector<std::array<std::uint32_t, 3>>& triangles,
              const Affine& map, const std::string& file, MeshBuilder& mesh);

}  // namespace cardioid::formats
