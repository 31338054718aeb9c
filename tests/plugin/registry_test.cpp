#include "rt_core/plugin/registry.hpp"

#include <gtest/gtest.h>

namespace cardioid::test {
namespace {

std::unique_ptr<LightingModule> no_lighting(const Params&, std::uint32_t) { return nullptr; }

TEST(Registry, KeepsKindsInTheOrderTheyCame) {
    const auto registry = make_registry();
    EXPECT_TRUE(registry->shaders().empty());
    for (const char* const name : {"c", "a", "b"}) registry->add(ShaderKind{name, "", {}, nullptr});
    ASSERT_EQ(registry->shaders().size(), 3U);
    EXPECT_STREQ(registry->shaders()[0].name, "c");
    EXPECT_STREQ(registry->shaders()[2].name, "b");
}

TEST(Registry, TakesANameOnceForEachKindOfHook) {
    const auto registry = make_registry();
    registry->add(ShaderKind{"x", "", {}, nullptr});
    registry->add(LightKind{"x", "", {}, nullptr});
    registry->add(LightingKind{"x", "", {}, no_lighting});
    registry->add(Format{"x", "", {}, nullptr, nullptr, nullptr});
    const auto expect_refused = [&](const auto& kind, const std::string& text) {
        try {
            registry->add(kind);
            FAIL() << "taken twice";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::usage);
            EXPECT_EQ(error.what(), text);
        }
    };
    expect_refused(ShaderKind{"x", "", {}, nullptr}, "there is already a shader named \"x\"");
    expect_refused(LightKind{"x", "", {}, nullptr}, "there is already a light named \"x\"");
    expect_refused(LightingKind{"x", "", {}, no_lighting}, "there is already a lighting named \"x\"");
    expect_refused(Format{"x", "", {}, nullptr, nullptr, nullptr}, "there is already a format named \"x\"");
    EXPECT_EQ(registry->shaders().size(), 1U);
}

}  // namespace
}  // namespace cardioid::test
