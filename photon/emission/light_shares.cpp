#include "photon/emission/light_shares.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <numeric>

namespace cardioid::photon {

std::vector<std::uint64_t> largest_remainder(std::span<const double> weights, std::uint64_t total) {
    std::vector<std::uint64_t> numbers(weights.size(), 0);
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    if (!(sum > 0)) return numbers;
    std::vector<double> remainder(weights.size());
    std::uint64_t given = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const double exact = weights[i] / sum * static_cast<double>(total);
        numbers[i] = std::min(static_cast<std::uint64_t>(exact), total - given);
        remainder[i] = exact - std::floor(exact);
        given += numbers[i];
    }
    std::vector<std::size_t> order(weights.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::erase_if(order, [&](std::size_t i) { return !(weights[i] > 0); });
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return remainder[a] > remainder[b]; });
    for (std::size_t i = 0; given < total; ++i, ++given) ++numbers[order[i % order.size()]];
    return numbers;
}

void check_count_of_a_light(std::uint64_t count) {
    if (count > most_of_a_light)
        throw Error(ErrorCode::limit,
                    fmt::format("photons: {} of one light, wanted at most {}", count, most_of_a_light));
}

Rgb total_power(std::span<const std::unique_ptr<Light>> lights) {
    Rgb sum;
    for (const auto& light : lights) sum += light->power();
    return sum;
}

}  // namespace cardioid::photon
