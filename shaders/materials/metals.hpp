#pragma once
#include <span>
#include <string>

#include "rt_core/api/math.hpp"

namespace cardioid::shaders {

/// Complex index eta + i k of a metal in the three channels.
struct Metal {
    const char* name;
    Rgb eta, k;
};

std::span<const Metal> metals();

/// The metal of that name, or null.
const Metal* find_metal(const std::string& name);

/// `one of gold, ...; found "glod" (did you mean "gold"?)`, for messages.
std::string metal_names(const std::string& found);

}  // namespace cardioid::shaders
