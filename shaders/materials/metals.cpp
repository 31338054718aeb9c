#include "shaders/materials/metals.hpp"

#include <algorithm>
#include <numeric>
#include <string_view>
#include <utility>
#include <vector>

namespace cardioid::shaders {
namespace {

// At 611, 549 and 464 nm, the dominant wavelengths of Rec.709's primaries, linear between the measured points of
// Johnson & Christy, Phys. Rev. B 6, 4370 (1972: Au, Ag, Cu) and 9, 5056 (1974: Cr, Fe, Ni, Ti), and of Rakic, Applied
// Optics 34, 4755 (1995: Al), as the public-domain refractiveindex.info database has them.
constexpr Metal table[] = {
    {"aluminium", {1.320F, 1.011F, 0.683F}, {7.307F, 6.616F, 5.623F}},
    {"chromium", {3.179F, 3.180F, 2.447F}, {3.300F, 3.330F, 3.205F}},
    {"copper", {0.367F, 1.016F, 1.246F}, {3.121F, 2.579F, 2.452F}},
    {"gold", {0.223F, 0.428F, 1.335F}, {3.204F, 2.460F, 1.872F}},
    {"iron", {2.890F, 2.950F, 2.642F}, {3.040F, 2.930F, 2.803F}},
    {"nickel", {1.985F, 1.920F, 1.763F}, {3.982F, 3.610F, 3.041F}},
    {"silver", {0.058F, 0.060F, 0.046F}, {4.103F, 3.589F, 2.792F}},
    {"titanium", {2.658F, 2.540F, 2.303F}, {3.696F, 3.430F, 3.079F}},
};

/// Letters to insert, delete or replace.
std::size_t edits(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = std::exchange(row[0], i);
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replace = diagonal + (a[i - 1] != b[j - 1]);
            diagonal = std::exchange(row[j], std::min({row[j] + 1, row[j - 1] + 1, replace}));
        }
    }
    return row.back();
}

}  // namespace

std::span<const Metal> metals() { return table; }

const Metal* find_metal(const std::string& name) {
    const std::string_view wanted = name == "aluminum" ? "aluminium" : std::string_view(name);
    const auto* found =
        std::find_if(std::begin(table), std::end(table), [&](const Metal& m) { return m.name == wanted; });
    return found == std::end(table) ? nullptr : found;
}

std::string metal_names(const std::string& found) {
    std::string text = "one of";
    for (const Metal& m : table) text += (&m == table ? " " : ", ") + std::string(m.name);
    text += "; found \"" + found + "\"";
    const auto distance = [&](const Metal& m) { return edits(found.substr(0, 100), m.name); };
    const auto* nearest = std::min_element(std::begin(table), std::end(table),
                                           [&](const Metal& a, const Metal& b) { return distance(a) < distance(b); });
    // Two swapped letters count two edits.
    if (distance(*nearest) <= std::max<std::size_t>(2, found.size() / 3))
        text += " (did you mean \"" + std::string(nearest->name) + "\"?)";
    return text;
}

}  // namespace cardioid::shaders
