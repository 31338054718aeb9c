#pragma once

namespace cardioid {

/// The best chance to live that Russian roulette gives a path after so many surfaces, however much it carries. Paths
/// that lose nothing must end, and those that lose little must not end faster than they lose, or the variance of what
/// they bring is infinite: with a limit c for all lengths it is wherever albedo^2 > c. 1 - 2/n leaves (m/n)^2 of the
/// paths after n surfaces, where it begins with m: their mean length is at most 2 m, and any albedo below 1 outweighs
/// the (n/m)^2 that their weight has grown to.
constexpr float best_chance(int surfaces) noexcept {
    constexpr int sure = 128;
    return surfaces < sure ? 1 : 1 - 2 / static_cast<float>(surfaces);
}

}  // namespace cardioid
