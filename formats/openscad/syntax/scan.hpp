#pragma once
#include <cstdint>
#include <string>
#include <string_view>

namespace cardioid::formats::openscad {

/// Length of the identifier ('$'? [A-Za-z0-9_]+) at the start of `s`, 0 where there is none.
std::size_t identifier_length(std::string_view s);

/// Length of the number (D+ [E] | D* '.' D+ [E] | D+ '.' D* [E], E = [eE][+-]?D+) at the start of `s`, or 0.
std::size_t number_length(std::string_view s);

/// Of a spelled number that no double holds: whether it is too large rather than too small.
bool is_huge(std::string_view number);

/// Whether a spelled number has a fraction or exponent and more than OpenSCAD's 6 significant digits.
bool is_long_fraction(std::string_view number);

/// Bytes of the UTF-8 character at the start of `s` (not empty); 1 where it is not UTF-8.
std::size_t character_length(std::string_view s);

/// Appends a code point; what is not one (surrogates, beyond U+10FFFF) becomes U+FFFD.
void append_utf8(std::string& out, std::uint32_t code);

}  // namespace cardioid::formats::openscad
