#include "photon/emission/batches.hpp"

#include <algorithm>

namespace cardioid::photon {

namespace {

/// How bright a light is for the shares: the sum over the channels, 0 for one that does not shine.
double brightness(const Light& light) {
    const Rgb power = light.power();
    const double sum = double{power.r} + double{power.g} + double{power.b};
    return std::isfinite(sum) && sum > 0 ? sum : 0;
}

void append(BatchList& list, const AimCell& cell, std::uint32_t stratum, std::uint64_t count) {
    check_count_of_a_light(count);
    list.batches.push_back({cell, stratum, list.total, static_cast<std::uint32_t>(count),
                            static_cast<float>(cell.volume() / static_cast<double>(count))});
    list.total += count;
}

}  // namespace

BatchList even_batches(std::span<const std::unique_ptr<Light>> lights, std::uint64_t count, Shares rule) {
    std::vector<double> weights;
    for (const auto& light : lights) {
        const double sum = brightness(*light);
        weights.push_back(rule == Shares::even && sum > 0 ? 1 : sum);
    }
    const std::vector<std::uint64_t> numbers = largest_remainder(weights, count);
    BatchList list;
    for (std::size_t i = 0; i < weights.size(); ++i)
        if (weights[i] > 0)
            append(list, {.light = static_cast<std::uint32_t>(i)}, 0, std::max<std::uint64_t>(numbers[i], 1));
    return list;
}

BatchList aimed_batches(std::span<const std::unique_ptr<Light>> lights, std::uint64_t count, const Aim& aim) {
    std::vector<double> weights;
    for (const AimCell& cell : aim.cells)
        weights.push_back(brightness(*lights[cell.light]) * cell.volume() * cell.density);
    const std::vector<std::uint64_t> numbers = largest_remainder(weights, count);
    BatchList list;
    std::uint32_t stratum = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        stratum = i > 0 && aim.cells[i].light == aim.cells[i - 1].light ? stratum + 1 : 0;
        if (weights[i] > 0) append(list, aim.cells[i], stratum, std::max<std::uint64_t>(numbers[i], 1));
    }
    return list;
}

}  // namespace cardioid::photon
