#include "formats/openscad/limits.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <fmt/format.h>

#include "rt_core/api/error.hpp"
#include "rt_core/scene/nearest_name.hpp"

namespace cardioid::formats::openscad {
namespace {

constexpr std::array specs{
    ParamSpec{"minkowski", ParamType::number, "5e7", "sums of corners that one minkowski() may form"},
    ParamSpec{"triangles", ParamType::number, "5e7", "triangles that one linear_extrude() may make"},
    ParamSpec{"cells", ParamType::number, "5e7", "cells that the height map of one surface() may have"},
    ParamSpec{"nesting", ParamType::number, "100000", "calls that may stand inside one another"}};

double value_of(const std::string& name, const std::string& text) {
    constexpr double most = 1e15;  // still a whole number in a double, and in 64 bits
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !(value >= 1 && value <= most))
        throw Error(ErrorCode::usage, fmt::format("--set csg.{}={}: wanted a number from 1 to {:g}", name, text, most));
    return value;
}

}  // namespace

std::span<const ParamSpec> limit_specs() { return specs; }

Limits limits_of(const ReadOptions& options) {
    Limits out;
    for (const auto& [name, text] : options.settings) {
        const double value = value_of(name, text);
        if (name == "minkowski")
            out.minkowski = value;
        else if (name == "triangles")
            out.triangles = value;
        else if (name == "cells")
            out.cells = value;
        else if (name == "nesting")
            out.nesting = static_cast<std::size_t>(value);
        else {
            std::array<std::string_view, specs.size()> names;
            for (std::size_t i = 0; i < specs.size(); ++i) names[i] = specs[i].name;
            throw Error(ErrorCode::usage, fmt::format("--set csg.{}={}: found option \"{}\", wanted {}{}", name, text,
                                                      name, fmt::join(names, ", "), did_you_mean(name, names)));
        }
    }
    return out;
}

}  // namespace cardioid::formats::openscad
