#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "formats/mesh/readers.hpp"

namespace cardioid::formats {

enum class PlyType : unsigned char { i8, u8, i16, u16, i32, u32, f32, f64 };

/// Bytes of a value in a binary file.
std::size_t size_of(PlyType type);

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::f32;
    bool is_list = false;
    PlyType count_type = PlyType::u8;  ///< of a list
};

struct PlyElement {
    std::string name;
    std::size_t count = 0;  ///< as written; not to be trusted
    std::vector<PlyProperty> properties;
    std::size_t line = 0;
    /// Fewest bytes an element takes in a binary file.
    [[nodiscard]] std::size_t least_size() const;
};

enum class PlyEncoding { ascii, little_endian, big_endian };

struct PlyHeader {
    PlyEncoding encoding = PlyEncoding::ascii;
    std::vector<PlyElement> elements;
    std::size_t size = 0;   ///< bytes before the data
    std::size_t lines = 0;  ///< of the header
};

/// Throws Error(bad_input) with file:line.
PlyHeader read_ply_header(const MeshText& text);

}  // namespace cardioid::formats
