#include "formats/brlcad/solid_kinds.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace cardioid::formats::brlcad {

namespace {

constexpr SolidField tor[] = {{"V", 3}, {"H", 3}, {"r_a", 1}, {"r_h", 1}};
constexpr SolidField tgc[] = {{"V", 3}, {"H", 3}, {"A", 3}, {"B", 3}, {"C", 3}, {"D", 3}};
constexpr SolidField ell[] = {{"V", 3}, {"A", 3}, {"B", 3}, {"C", 3}};
constexpr SolidField arb8[] = {{"V1", 3}, {"V2", 3}, {"V3", 3}, {"V4", 3}, {"V5", 3}, {"V6", 3}, {"V7", 3}, {"V8", 3}};
constexpr SolidField half[] = {{"N", 3}, {"d", 1}};
constexpr SolidField part[] = {{"V", 3}, {"H", 3}, {"r_v", 1}, {"r_h", 1}};
constexpr SolidField rpc[] = {{"V", 3}, {"H", 3}, {"B", 3}, {"r", 1}};
constexpr SolidField rhc[] = {{"V", 3}, {"H", 3}, {"B", 3}, {"r", 1}, {"c", 1}};
constexpr SolidField epa[] = {{"V", 3}, {"H", 3}, {"A", 3}, {"r_1", 1}, {"r_2", 1}};
constexpr SolidField ehy[] = {{"V", 3}, {"H", 3}, {"A", 3}, {"r_1", 1}, {"r_2", 1}, {"c", 1}};
constexpr SolidField eto[] = {{"V", 3}, {"N", 3}, {"C", 3}, {"r", 1}, {"r_d", 1}};
constexpr SolidField hyp[] = {{"V", 3}, {"H", 3}, {"A", 3}, {"b", 1}, {"bnr", 1}};
constexpr SolidField superell[] = {{"V", 3}, {"A", 3}, {"B", 3}, {"C", 3}, {"n", 1}, {"e", 1}};
constexpr SolidField cline[] = {{"t", 1}, {"r", 1}, {"V", 3}, {"H", 3}};

constexpr SolidRow rows[] = {{SolidKind::tor, "tor", 1, 16, tor},
                             {SolidKind::tgc, "tgc", 2, 18, tgc},
                             {SolidKind::ell, "ell", 3, 19, ell},
                             {SolidKind::arb8, "arb8", 4, 20, arb8},
                             {SolidKind::half, "half", 6, 24, half},
                             {SolidKind::part, "part", 16, 0, part},
                             {SolidKind::rpc, "rpc", 17, 26, rpc},
                             {SolidKind::rhc, "rhc", 18, 27, rhc},
                             {SolidKind::epa, "epa", 19, 28, epa},
                             {SolidKind::ehy, "ehy", 20, 29, ehy},
                             {SolidKind::eto, "eto", 21, 30, eto},
                             {SolidKind::hyp, "hyp", 38, 33, hyp},
                             {SolidKind::superell, "superell", 35, 0, superell},
                             {SolidKind::cline, "cline", 29, 0, cline}};

template <class Fits>
const SolidRow* find(const Fits& fits) {
    const auto found = std::find_if(std::begin(rows), std::end(rows), fits);
    return found == std::end(rows) ? nullptr : found;
}

}  // namespace

std::size_t SolidRow::count() const {
    std::size_t n = 0;
    for (const SolidField& field : fields) n += static_cast<std::size_t>(field.count);
    return n;
}

std::span<const SolidRow> solid_rows() { return rows; }
const SolidRow* find_row(std::string_view name) {
    return find([&](const SolidRow& row) { return row.name == name; });
}
const SolidRow* find_row_by_minor(int minor) {
    return find([&](const SolidRow& row) { return row.minor == minor; });
}
const SolidRow* find_row_by_v4(int type) {
    return type == 0 ? nullptr : find([&](const SolidRow& row) { return row.v4 == type; });
}

std::string minor_name(int minor) {
    static const std::map<int, const char*> others{
        {5, "ars"},       {7, "rec"},    {8, "poly"},        {9, "bspline"},  {10, "sph"},      {11, "nmg"},
        {12, "ebm"},      {13, "vol"},   {14, "arbn"},       {15, "pipe"},    {22, "grip"},     {23, "joint"},
        {24, "hf"},       {25, "dsp"},   {26, "sketch"},     {27, "extrude"}, {28, "submodel"}, {30, "bot"},
        {36, "metaball"}, {37, "brep"},  {39, "constraint"}, {40, "revolve"}, {41, "pnts"},     {42, "annot"},
        {43, "hrt"},      {44, "datum"}, {45, "script"},     {46, "material"}};
    if (const SolidRow* row = find_row_by_minor(minor)) return row->name;
    const auto found = others.find(minor);
    return found == others.end() ? fmt::format("type {}", minor) : found->second;
}

SolidKind kind_without_body(std::string_view name) {
    static constexpr std::string_view nothing[] = {"grip",  "joint",  "pnts",     "constraint",
                                                   "annot", "script", "material", "datum"};
    return std::find(std::begin(nothing), std::end(nothing), name) == std::end(nothing) ? SolidKind::unsupported
                                                                                        : SolidKind::nothing;
}

std::map<std::string, std::string> fields_of(std::string_view text) {
    std::map<std::string, std::string> out;
    const auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\0'; };
    std::size_t at = 0;
    while (at < text.size()) {
        while (at < text.size() && is_blank(text[at])) ++at;
        const std::size_t key = at;
        while (at < text.size() && !is_blank(text[at]) && text[at] != '=') ++at;
        if (at == text.size() || text[at] != '=') continue;
        const std::string name(text.substr(key, at++ - key));
        const char ends = at < text.size() ? text[at] : ' ';
        const bool quoted = ends == '"' || ends == '{';
        if (quoted) ++at;
        const std::size_t value = at;
        while (at < text.size() && (quoted ? text[at] != (ends == '"' ? '"' : '}') : !is_blank(text[at]))) ++at;
        out[name] = std::string(text.substr(value, at - value));
        if (quoted && at < text.size()) ++at;
    }
    return out;
}

}  // namespace cardioid::formats::brlcad
