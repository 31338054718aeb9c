#include "rt_core/scene/nearest_name.hpp"

#include <algorithm>

namespace cardioid {
namespace {

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// Optimal string alignment distance: Levenshtein's with swaps of neighbours.
std::size_t edits(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before, last(b.size() + 1), now(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        now[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t change = lower(a[i - 1]) == lower(b[j - 1]) ? 0 : 1;
            now[j] = std::min({last[j] + 1, now[j - 1] + 1, last[j - 1] + change});
            if (i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) && lower(a[i - 2]) == lower(b[j - 1]))
                now[j] = std::min(now[j], before[j - 2] + 1);
        }
        before = last;
        last = now;
    }
    return last[b.size()];
}

}  // namespace

std::string nearest_name(std::string_view name, std::span<const std::string_view> candidates) {
    constexpr std::size_t longest = 64;  // no name of ours; keeps the search quick
    if (name.size() > longest) return {};
    std::string_view best;
    std::size_t fewest = name.size() / 3 + 1;
    for (const std::string_view candidate : candidates) {
        if (candidate.size() > longest) continue;
        const std::size_t n = edits(name, candidate);
        if (n < fewest) {
            fewest = n;
            best = candidate;
        }
    }
    return std::string(best);
}

std::string did_you_mean(std::string_view name, std::span<const std::string_view> candidates) {
    const std::string near = nearest_name(name, candidates);
    return near.empty() ? std::string{} : " (did you mean \"" + near + "\"?)";
}

}  // namespace cardioid
