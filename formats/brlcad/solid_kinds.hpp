#pragma once
#include <span>
#include <string_view>

#include "formats/brlcad/database.hpp"

namespace cardioid::formats::brlcad {

/// A parameter of a solid and how many numbers it has.
struct SolidField {
    const char* name;
    int count;
};

/// How a kind of solid is written: the fields' names are those of the text form, their order that of the binary one.
struct SolidRow {
    SolidKind kind;
    const char* name;
    int minor;  ///< type in the binary form
    int v4;     ///< type of an `S` record, 0 where it has another letter
    std::span<const SolidField> fields;
    [[nodiscard]] std::size_t count() const;
};

/// Kinds whose numbers are always as many; pipe, arbn and bot are read by themselves.
std::span<const SolidRow> solid_rows();
const SolidRow* find_row(std::string_view name);
const SolidRow* find_row_by_minor(int minor);
const SolidRow* find_row_by_v4(int type);

/// BRL-CAD's name of a type of the binary form, "type 99" where there is none.
std::string minor_name(int minor);

/// Of a type that has no numbers to be read: SolidKind::nothing, else SolidKind::unsupported.
SolidKind kind_without_body(std::string_view name);

/// The pairs of a text `file="x" w=2 mat=1,0,0`, the way dsp, ebm, vol and hf are written.
std::map<std::string, std::string> fields_of(std::string_view text);

}  // namespace cardioid::formats::brlcad
