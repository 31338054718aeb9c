#include <cstdlib>
#include <functional>
#include <gtest/gtest.h>
#include <random>

#include "formats/brlcad/brlcad_format.hpp"
#include "formats/openscad/openscad_format.hpp"
#include "rt_core/plugin/registry.hpp"
#include "rt_core/scene/scene.hpp"
#include "tests/brlcad/database_writer.hpp"

namespace cardioid::formats {
namespace {

/// Changes, cuts, doubles or inserts some bytes, at places and of values that readers stumble over.
std::string mutated(std::string text, std::mt19937& random) {
    const auto below = [&](std::size_t n) {
        return n == 0 ? 0 : std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
    };
    static const std::string words[] = {"{",  "}",  "\"", "-1",    "1e308", "nan",          "4294967295",
                                        "\n", "\0", ";",  "{l a}", "#",     "9999999999999"};
    for (std::size_t i = 1 + below(4); i > 0 && !text.empty(); --i) {
        const std::size_t at = below(text.size());
        switch (below(6)) {
            case 0:
                text[at] = static_cast<char>(below(256));
                break;
            case 1:
                text[at] = static_cast<char>(text[at] ^ (1 << below(8)));
                break;
            case 2:
                text.erase(at, 1 + below(16));
                break;
            case 3:
                text.insert(at, words[below(std::size(words))]);
                break;
            case 4:
                text.insert(at, text.substr(below(text.size()), below(64)));
                break;
            default:
                if (below(8) == 0) text.resize(at);
                text[below(text.size() + 1) % std::max<std::size_t>(text.size(), 1)] = "\xFF\x7F\x80\x00"[below(4)];
        }
    }
    return text;
}

std::size_t mutations() {
    const char* given = std::getenv("CARDIOID_MUTATIONS");
    return given ? static_cast<std::size_t>(std::strtoull(given, nullptr, 10)) : 2000;
}

/// What a reader may do with a broken file is to throw Error; anything else ends the test.
void survive(const std::string& sample, unsigned seed, const std::function<void(const std::string&)>& read) {
    std::mt19937 random(seed);
    std::size_t refused = 0;
    for (std::size_t i = 0; i < mutations(); ++i) {
        const std::string text = mutated(sample, random);
        try {
            read(text);
        } catch (const Error& error) {
            ++refused;
            ASSERT_FALSE(std::string(error.what()).empty());
        }
    }
    EXPECT_GT(refused, 0U);  // else nothing was damaged
}

TEST(DamagedFiles, OfDatabasesAreReadOrRefused) {
    const auto read = [](const std::string& text) { static_cast<void>(brlcad_format.read(text, "model", {})); };
    survive(test::small_binary(), 1, read);
    survive(test::small_text_v4(), 2, read);
    survive(test::small_text_v5(), 3, read);
}

TEST(DamagedFiles, OfScenesAreReadOrRefused) {
    const std::unique_ptr<Registry> registry = make_registry();
    ReadOptions options;
    options.registry = registry.get();
    const std::string sample =
        "difference() { cube([4, 5, 6], center = true); translate([1, 0, 0]) sphere(r = 2, $fn = 8); }\n"
        "multmatrix([[1, 0, 0, 3], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]) cylinder(h = 2, r1 = 1, r2 = 0.5);\n"
        "polyhedron(points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], faces = [[0, 1, 2], [0, 3, 1], [1, 3, 2], "
        "[2, 3, 0]]);\n";
    survive(sample, 4,
            [&](const std::string& text) { static_cast<void>(csg_format.read(text, "model.csg", options)); });
}

}  // namespace
}  // namespace cardioid::formats
