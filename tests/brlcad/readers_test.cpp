#include "formats/brlcad/read/readers.hpp"

#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>
#include <zlib.h>

#include "csg/compile.hpp"
#include "csg/measure.hpp"
#include "formats/brlcad/brlcad_format.hpp"
#include "rt_core/render/commit/scene_digest.hpp"
#include "rt_core/scene/scene.hpp"
#include "tests/brlcad/database_writer.hpp"

namespace cardioid::formats {
namespace {

Scene scene_of(const std::string& text, const std::string& file = "model") {
    return brlcad_format.read(text, file, {});
}

std::string message_of(const std::string& text) {
    try {
        static_cast<void>(scene_of(text));
    } catch (const Error& error) {
        return error.what();
    }
    return "nothing was thrown";
}

TEST(Databases, AreTheSameSceneFromEachOfTheThreeForms) {
    const Scene binary = scene_of(test::small_binary());
    EXPECT_EQ(scene_hash(binary), scene_hash(scene_of(test::small_text_v5())));
    EXPECT_EQ(scene_hash(binary), scene_hash(scene_of(test::small_text_v4())));
    ASSERT_EQ(binary.names, (std::vector<std::string>{"/all.g/ball.r", "/all.g/box.r"}));
    EXPECT_EQ(binary.tops, std::vector<std::string>{"all.g"});
    EXPECT_TRUE(binary.warnings.empty());
}

TEST(Databases, TellTheirTitleUnitsTopsAndCounts) {
    const Scene text = scene_of(test::small_text_v5()), binary = scene_of(test::small_binary());
    EXPECT_EQ(text.facts, binary.facts);
    ASSERT_EQ(text.facts.size(), 4U);
    EXPECT_EQ(text.facts[2], (std::pair<std::string, std::string>{"top objects", "all.g"}));
    EXPECT_EQ(text.facts[3].second.find("3 combinations, 2 of them regions; "), 0U) << text.facts[3].second;
    const Scene inches = scene_of("title {a block}\nunits in\nput {b.s} ell V {0 0 0} A {9 0 0} B {0 9 0} C {0 0 9}\n");
    EXPECT_EQ(inches.facts[0].second, "a block");
    EXPECT_EQ(inches.facts[1].second, "in");
    EXPECT_EQ(inches.facts[3].second, "0 combinations, 0 of them regions; 1 solids: 1 ell");
}

TEST(Databases, SolidsInNoCombinationAreDrawnOnlyWhereTheyAreNamed) {
    const std::string left = "put {left.s} ell V {0 0 0} A {9 0 0} B {0 9 0} C {0 0 9}\n";
    const Scene scene = scene_of(test::small_text_v5() + left);
    EXPECT_EQ(scene.names, (std::vector<std::string>{"/all.g/ball.r", "/all.g/box.r"}));
    EXPECT_EQ(scene.tops, (std::vector<std::string>{"all.g", "left.s"}));
    ASSERT_EQ(scene.warnings.size(), 1U);
    EXPECT_NE(scene.warnings[0].find("left.s"), std::string::npos);
    EXPECT_EQ(brlcad_format.read(test::small_text_v5() + left, "model", {.objects = {"left.s"}}).names.size(), 1U);
    EXPECT_EQ(scene_of("title {only a solid}\nunits mm\n" + left).names.size(), 1U);
}

TEST(Looks, AHollowBallAroundAllElseIsTheSky) {
    const auto model = [](const std::string& shader, double radius) {
        return fmt::format(
            "title {{t}}\nunits mm\n"
            "put {{box.s}} ell V {{0 0 0}} A {{2 0 0}} B {{0 2 0}} C {{0 0 2}}\n"
            "put {{out.s}} ell V {{0 0 0}} A {{{0} 0 0}} B {{0 {0} 0}} C {{0 0 {0}}}\n"
            "put {{in.s}} ell V {{0 0 0}} A {{1 0 0}} B {{0 1 0}} C {{0 0 1}}\n"
            "put {{box.r}} comb region yes tree {{l box.s}}\n"
            "put {{dome.r}} comb region yes shader {{{1}}} tree {{- {{l out.s}} {{l in.s}}}}\n"
            "put {{all.g}} comb region no tree {{u {{l box.r}} {{l dome.r}}}}\n",
            radius, shader);
    };
    for (const char* shader : {"cloud", "checker", "plastic"}) {
        const Scene scene = scene_of(model(shader, 9));
        EXPECT_EQ(scene.names, std::vector<std::string>{"/all.g/box.r"}) << shader;
        ASSERT_EQ(scene.lights.size(), 1U) << shader;
        EXPECT_EQ(scene.lights[0].kind, "sky");
    }
    EXPECT_EQ(scene_of(model("cloud", 1.9)).names.size(), 2U) << "it is not around all else";
    EXPECT_EQ(scene_of(model("glass", 9)).names.size(), 2U);
    EXPECT_TRUE(scene_of(model("light", 9)).lights.empty());
}

TEST(Databases, ColoursComeFromCombinationsElseByNumber) {
    const Scene scene = scene_of(test::small_binary());
    const auto colour = [&](std::size_t root) {
        const SolidNode* node = &scene.solids.nodes[scene.solids.roots[root]];
        while (node->op != SolidOp::leaf) node = &scene.solids.nodes[scene.solids.children[node->first]];
        return scene.materials[scene.solids.leaves[node->first].material].params.colour("reflectance", {});
    };
    EXPECT_GT(colour(0).r, 0.8F);
    EXPECT_EQ(colour(0).g, 0);
    EXPECT_EQ(colour(1).r, 0);
    EXPECT_GT(colour(1).g, 0.8F);
}

TEST(Databases, PackedBodiesAreUnpacked) {
    using W = test::DatabaseWriter;
    const std::string body = W::reals({0, 0, 0, 5, 0, 0, 0, 5, 0, 0, 0, 5});
    std::string packed(compressBound(body.size()), '\0');
    uLongf size = packed.size();
    ASSERT_EQ(compress(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(body.data()),
                       body.size()),
              Z_OK);
    packed.resize(size);
    W out;
    out.add(1, 3, "ball.s", {}, packed, 1);
    EXPECT_EQ(scene_of(out.bytes()).solids.leaves.size(), 1U);
    W broken;
    broken.add(1, 3, "ball.s", {}, packed.substr(0, 10), 1);
    EXPECT_NE(message_of(broken.bytes()).find("zlib cannot unpack"), std::string::npos);
}

TEST(Databases, ErrorsNameTheirPlace) {
    std::string cut = test::small_binary();
    cut.resize(cut.size() - 8);
    EXPECT_NE(message_of(cut).find("model:"), std::string::npos) << message_of(cut);
    EXPECT_EQ(message_of("title {x}\nput {a} ell V {1 2}\n"), "model:2:16: found 2 numbers, wanted 3");
    EXPECT_EQ(message_of("I 1 v4\nx\nS 19 a 3 0 nine\n"),
              "model:3:12: found \"nine\", wanted a solid's number, a number");
    EXPECT_EQ(message_of("put {a} comb region no tree {x {l b} {l c}}\n"),
              "model:1:30: found operation \"x\", wanted u, -, n, +, ^, ! or l");
    EXPECT_NE(message_of("something else").find("found no BRL-CAD database"), std::string::npos);
}

TEST(Databases, WhatIsNotThereOrNotKnownIsNamedOnceAndCountsAsNothing) {
    ReadOptions options;
    options.objects = {"loop"};
    const Scene scene = brlcad_format.read(
        "put {a.s} ell V {0 0 0} A {1 0 0} B {0 1 0} C {0 0 1}\nput {b.s} nmg x y\n"
        "put {r} comb region yes tree {u {u {- {l a.s} {l gone}} {l gone}} {l b.s}}\n"
        "put {loop} comb region no tree {u {l r} {l loop}}\n",
        "model.asc", options);
    ASSERT_EQ(scene.warnings.size(), 3U);
    EXPECT_NE(scene.warnings[0].find("no object \"gone\" (named in \"r\")"), std::string::npos) << scene.warnings[0];
    EXPECT_NE(scene.warnings[1].find("type \"nmg\""), std::string::npos) << scene.warnings[1];
    EXPECT_NE(scene.warnings[2].find("within itself"), std::string::npos) << scene.warnings[2];
    EXPECT_EQ(scene.solids.roots.size(), 1U);
}

TEST(Databases, ReadFromAFolderAreTheSameInBothForms) {
    const char* folder = std::getenv("CARDIOID_BRLCAD_MODELS");
    if (!folder) GTEST_SKIP() << "CARDIOID_BRLCAD_MODELS names no folder of .g and .asc files";
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        std::filesystem::path text = entry.path();
        if (text.extension() != ".g" || !std::filesystem::exists(text.replace_extension(".asc"))) continue;
        const auto content = [](const std::filesystem::path& path) {
            std::ostringstream out;
            out << std::ifstream(path, std::ios::binary).rdbuf();
            return out.str();
        };
        const Scene a = scene_of(content(entry.path())), b = scene_of(content(text));
        EXPECT_EQ(a.names, b.names) << text;
        EXPECT_EQ(a.solids.nodes.size(), b.solids.nodes.size()) << text;
        EXPECT_EQ(a.materials.size(), b.materials.size()) << text;
        // The text form has 12 or more digits.
        ASSERT_EQ(a.solids.leaves.size(), b.solids.leaves.size()) << text;
        for (std::size_t i = 0; i < a.solids.leaves.size(); ++i) {
            const Leaf &x = a.solids.leaves[i], &y = b.solids.leaves[i];
            EXPECT_EQ(x.kind, y.kind) << text;
            const double size = 1 + length(x.to_world.t) + length(x.to_world.column(0)) + length(x.to_world.column(2));
            EXPECT_LT(length(x.to_world.t - y.to_world.t), 1e-6 * size) << text << ' ' << i;
        }
    }
}

}  // namespace
}  // namespace cardioid::formats
