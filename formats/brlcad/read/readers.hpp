#pragma once
#include <string>
#include <string_view>

#include "formats/brlcad/database.hpp"

namespace cardioid::formats::brlcad {

/// Each reads a whole file; `file` is its name for messages. Throws Error(bad_input) with file:offset (binary) or
/// file:line:column (text). Memory is bounded by the size of the file, and by a limit on what is unpacked.
Database read_binary(std::string_view bytes, const std::string& file);
/// The text form of version 4: records of one letter.
Database read_text_v4(std::string_view text, const std::string& file);
/// That of version 5: commands in Tcl's syntax.
Database read_text_v5(std::string_view text, const std::string& file);

/// Whether the first bytes are those of each form.
bool looks_binary(std::string_view head);
bool looks_like_text_v4(std::string_view head);
bool looks_like_text_v5(std::string_view head);

/// Which of a bot's plates are appended: bit i of the number that the hexadecimal digits are.
std::vector<bool> appended_plates(std::string_view digits, std::size_t plates);

/// What a solid's body says, in place of its kind's own fields: pipe, arbn, bot, or an unsupported type.
Solid read_body(int minor, std::string_view body, const std::string& file, std::size_t offset);
/// A combination's tree, without its attributes.
Combination read_combination(std::string_view body, const std::string& file, std::size_t offset);

/// Bytes that gzip or zlib packed; throws Error(bad_input), or Error(limit) where they are more than `most`.
std::string unpack(std::string_view packed, std::size_t most, const std::string& place);

}  // namespace cardioid::formats::brlcad
