#include "tests/fuzz/mutate.hpp"

#include <algorithm>
#include <cstdlib>
#include <gtest/gtest.h>

#include "rt_core/api/error.hpp"

namespace cardioid::test {

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

void survive(const std::string& sample, unsigned seed, const std::function<void(const std::string&)>& read,
             std::size_t share) {
    std::mt19937 random(seed);
    std::size_t refused = 0;
    for (std::size_t i = 0; i < mutations() / share; ++i) {
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

}  // namespace cardioid::test
