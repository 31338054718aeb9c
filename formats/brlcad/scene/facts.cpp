#include "formats/brlcad/scene/facts.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>

namespace cardioid::formats::brlcad {

namespace {

/// `2 tgc, 1 tor`, the most first.
std::string counts_of(const std::map<std::string, std::size_t>& counts) {
    std::vector<std::pair<std::string, std::size_t>> order(counts.begin(), counts.end());
    std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
    std::string text;
    for (const auto& [name, count] : order) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, name);
    return text;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> facts_of(const Database& database,
                                                          const std::vector<std::string>& tops) {
    std::map<std::string, std::size_t> solids;
    std::size_t combinations = 0, regions = 0, all_solids = 0;
    for (const Object& object : database.objects) {
        if (object.combination) {
            ++combinations;
            regions += object.combination->region;
        } else {
            ++all_solids;
            ++solids[object.solid.type];
        }
    }
    std::string objects =
        fmt::format("{} combinations, {} of them regions; {} solids", combinations, regions, all_solids);
    if (all_solids > 0) objects += ": " + counts_of(solids);
    return {{"title", database.title},
            {"units", unit_name(database.unit_mm)},
            {"top objects", fmt::format("{}", fmt::join(tops, " "))},
            {"objects", objects}};
}

}  // namespace cardioid::formats::brlcad
