#pragma once
#include <string>
#include <string_view>

#include "formats/mesh/mesh_builder.hpp"

namespace cardioid::formats {

/// A file's bytes and its name for messages.
struct MeshText {
    std::string_view bytes;
    const std::string& file;
};

/// Each throws Error(bad_input) with file:line or file:byte, and holds no more memory than the file's size allows.
void read_stl(const MeshText& text, MeshBuilder& mesh);
void read_obj(const MeshText& text, MeshBuilder& mesh);
void read_ply(const MeshText& text, MeshBuilder& mesh);
void read_off(const MeshText& text, MeshBuilder& mesh);
/// CGAL's text of a Nef polyhedron; its facets are planes, holes in them are filled around.
void read_nef3(const MeshText& text, MeshBuilder& mesh);
/// As XML or within a ZIP archive; all objects where they stand, numbers as written: the unit and constellations are
/// ignored, as by OpenSCAD 2021.01.
void read_amf(const MeshText& text, MeshBuilder& mesh);
/// All objects as the build places them, in millimetres.
void read_3mf(const MeshText& text, MeshBuilder& mesh);
/// Text or GLB; all triangles of the scene as its nodes place them, y up becoming z up.
void read_gltf(const MeshText& text, MeshBuilder& mesh);

/// Whether the bytes are as long as a binary STL's triangle count says.
bool is_binary_stl(std::string_view bytes);

}  // namespace cardioid::formats
