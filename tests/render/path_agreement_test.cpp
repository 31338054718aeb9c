#include <gtest/gtest.h>

#include "path_kit.hpp"

/// `path` against tracers that share nothing with it but the hooks, and against itself asked otherwise.
namespace cardioid {
namespace {

using test::expect_mean;
using test::Moments;
using test::PathKit;
using test::SceneKit;

/// A bright room with everything in it; large lamps, so that a path without any art finds them.
SceneKit crowded_room() {
    SceneKit kit;
    const auto wall = kit.material("wall", "diffuse", {{"reflectance", {0.7}}});
    const auto glass = kit.material("glass", "dielectric", {{"absorption", {0.2}}});
    const auto metal = kit.material("metal", "conductor", {{"roughness", {0.4}}});
    const auto shiny = kit.material("shiny", "plastic", {{"reflectance", {0.6}}});
    const auto glossy = kit.material("glossy", "phong", {{"diffuse", {0.4}}, {"specular", {0.4}}, {"exponent", {30}}});
    const auto foil = kit.material("foil", "filter", {{"reflectance", {0.4}}, {"transmittance", {0.5}}});
    const auto frosted = kit.material("frosted", "dielectric", {{"roughness", {0.5}}});
    const auto glow = kit.material("glow", "diffuse", {{"reflectance", {0.5}}, {"emission", {2}}});
    const auto outer = kit.box({-1, -1, -1}, {5, 5, 4}, wall), inner = kit.box({0, 0, 0}, {4, 4, 3}, wall);
    kit.root(kit.scene.solids.add_node(SolidOp::subtract, {outer, inner}));
    kit.root(kit.ball({1, 1, 0.5}, 0.5, glass));
    kit.root(kit.ball({2, 1.2, 0.5}, 0.5, metal));
    kit.root(kit.ball({3, 1, 0.5}, 0.5, shiny));
    kit.root(kit.box({0, 3.9, 0}, {4, 4, 3}, glossy));
    kit.root(kit.box({0.2, 2, 0.1}, {1.8, 2.1, 1}, foil));
    kit.root(kit.ball({2.4, 2.4, 0.4}, 0.4, frosted));
    kit.root(kit.ball({3.4, 2.6, 0.6}, 0.5, glow));
    kit.light("area_light", {{"size", {2, 1.5}}, {"radiance", {3}}}, Affine::translation({1.6, 2, 2.9}));
    return kit;
}

const std::pair<Vec3d, Vec3d> views[] = {
    {{2, 0.1, 1.5}, {-0.4, 0.4, -0.5}},  // glass
    {{2, 0.1, 1.5}, {0, 1.1, -0.9}},     // rough metal
    {{2, 0.1, 1.5}, {0.5, 0.5, -0.55}},  // plastic
    {{2, 0.1, 1.5}, {0.1, 1, 0.1}},      // glossy wall
    {{1, 0.5, 0.6}, {0, 1, 0.05}},       // through the foil
    {{2.4, 0.5, 2}, {0, 1, -0.85}},      // frosted glass
    {{2, 2, 2}, {-0.2, -0.3, -1}},       // floor
};

TEST(PathAgreement, WithATracerThatAsksNoLight) {
    const SceneKit kit = crowded_room();
    const CommittedScene scene = kit.commit();
    const PathKit path(scene);
    constexpr std::uint32_t samples = 100 * test::batch;
    std::vector<double> all(samples), all_plain(samples);
    for (const auto& [o, d] : views) {
        Moments plain;
        for (std::uint32_t i = 0; i < samples; ++i) {
            Sampler sampler(9, Purpose::test, i / test::batch, i % test::batch);
            const double L = test::brute_force(scene, {o, normalize(d), Box3d::infinity, {}, {}}, sampler);
            plain.add(L);
            all_plain[i] += L;
        }
        Moments found;
        path.along(o, d, samples, [&, i = std::size_t{0}](const LightParts& parts) mutable {
            found.add(static_cast<double>(parts.sum().g));
            all[i++] += static_cast<double>(parts.sum().g);
        });
        test::expect_agreement(found, plain.mean(), "view", plain.error());
    }
    // One view alone does not see 2 %, all together do.
    Moments sum, plain_sum;
    for (const double L : all) sum.add(L);
    for (const double L : all_plain) plain_sum.add(L);
    expect_mean(sum, plain_sum.mean(), "all views", plain_sum.error());
}

TEST(PathAgreement, OfAllThatIsAskedAtAPointWithWhatTheEyeSees) {
    const SceneKit kit = crowded_room();
    const CommittedScene scene = kit.commit();
    const PathKit path(scene);
    double caustics = 0;
    for (const std::size_t view : {1U, 3U, 6U, 7U}) {
        const auto& [o, d] = views[view];
        Moments direct, caustic, indirect;
        path.along(o, d, 60 * test::batch, [&](const LightParts& parts) {
            direct.add(static_cast<double>(parts.direct.g));
            caustic.add(static_cast<double>(parts.caustic.g));
            indirect.add(static_cast<double>(parts.indirect.g));
        });
        const PathKit::AtPoint at = path.at_point(o, d, 60 * test::batch);
        test::expect_agreement(at.direct, direct.mean(), "direct", direct.error());
        test::expect_agreement(at.indirect, indirect.mean(), "indirect", indirect.error());
        test::expect_agreement(at.caustic, caustic.mean(), "caustic", caustic.error());
        caustics += caustic.mean();
    }
    EXPECT_GT(caustics, 0);
}

/// Scenes that have light of one way only, besides what goes straight to the eye.
TEST(PathAgreement, OfTheLayersWithTheWaysThatThereAre) {
    const auto parts_of = [](const SceneKit& kit, Vec3d o, Vec3d d) {
        const CommittedScene scene = kit.commit();
        LightParts sum;
        PathKit(scene).along(o, d, 2000, [&](const LightParts& p) {
            sum.emission += p.emission, sum.direct += p.direct, sum.specular += p.specular;
            sum.caustic += p.caustic, sum.indirect += p.indirect;
        });
        return sum;
    };
    const auto only = [](const LightParts& parts, Rgb LightParts::*part, const char* what) {
        EXPECT_GT((parts.*part).g, 0) << what;
        EXPECT_EQ(parts.sum().g, (parts.*part).g) << what;
    };
    SceneKit floor;
    floor.root(floor.box({-9, -9, -1}, {9, 9, 0}, 0));
    floor.light("disk_light", {{"r", {1}}, {"radiance", {1}}}, Affine::translation({0, 0, 3}));
    only(parts_of(floor, {0, 5, 1}, {0, -2.5, 1}), &LightParts::emission, "lamp");
    only(parts_of(floor, {0, 5, 1}, {0, -2, -1}), &LightParts::direct, "floor");

    SceneKit mirrored;
    mirrored.root(mirrored.box({-9, -9, -1}, {9, 9, 0}, mirrored.material("mirror", "mirror", {})));
    mirrored.light("disk_light", {{"r", {1}}, {"radiance", {1}}}, Affine::translation({0, 0, 3}));
    only(parts_of(mirrored, {0, 3, 1}, {0, -0.75, -1}), &LightParts::specular, "mirror");

    // The lamp shines up, onto a mirror, and down again beside itself.
    SceneKit thrown;
    thrown.root(thrown.box({-9, -9, -1}, {9, 9, 0}, 0));
    thrown.root(thrown.box({-9, -9, 4}, {9, 9, 5}, thrown.material("mirror", "mirror", {})));
    const Affine upward{{Vec3d{1, 0, 0}, {0, -1, 0}, {0, 0, -1}}, {0, 0, 2}};
    thrown.light("disk_light", {{"r", {1}}, {"radiance", {1}}}, upward);
    const CommittedScene scene = thrown.commit();
    LightParts sum;
    PathKit(scene, {{"depth", 2}}).along({0, 5, 1}, {0, -2, -1}, 2000, [&](const LightParts& p) {
        sum.direct += p.direct, sum.caustic += p.caustic, sum.indirect += p.indirect;
    });
    EXPECT_GT(sum.caustic.g, 0);
    EXPECT_EQ(sum.direct.g + sum.indirect.g, 0);

    // A plate between hides the lamp from the floor; a matt ceiling throws its light down.
    SceneKit bounced;
    bounced.root(bounced.box({-9, -9, -1}, {9, 9, 0}, 0));
    bounced.root(bounced.box({-9, -9, 4}, {9, 9, 5}, 0));
    bounced.light("disk_light", {{"r", {1}}, {"radiance", {1}}}, upward);
    only(parts_of(bounced, {0, 5, 1}, {0, -2, -1}), &LightParts::indirect, "ceiling");
}

TEST(PathAgreement, OfOneBounceWithDirectLightForEveryLamp) {
    struct Lamp {
        const char* kind;
        std::initializer_list<std::pair<const char*, std::vector<double>>> values;
    };
    const Lamp lamps[] = {
        {"point_light", {{"intensity", {3}}}},
        {"spot_light", {{"intensity", {9}}}},
        {"area_light", {{"size", {2, 1}}, {"radiance", {3}}}},
        {"area_light", {{"size", {2, 1}}, {"radiance", {3}}, {"visible", {0}}}},
        {"disk_light", {{"r", {0.7}}, {"radiance", {3}}}},
        {"sphere_light", {{"r", {0.5}}, {"radiance", {3}}}},
        {"sun", {{"direction", {0.2, 0.3, -1}}, {"irradiance", {2}}, {"angle", {20}}}},
        {"sun", {{"direction", {0.2, 0.3, -1}}, {"irradiance", {2}}, {"angle", {0}}}},
        {"sky", {{"radiance", {0.5}}}},
    };
    for (const Lamp& lamp : lamps) {
        SceneKit kit;
        const auto glossy =
            kit.material("glossy", "phong", {{"diffuse", {0.4}}, {"specular", {0.4}}, {"exponent", {20}}});
        const auto foil = kit.material("foil", "filter", {{"reflectance", {0}}, {"transmittance", {0.6}}});
        kit.root(kit.box({-9, -9, -1}, {9, 9, 0}, glossy));
        kit.root(kit.box({-0.4, -9, 1}, {9, 9, 1.1}, foil));
        kit.light(lamp.kind, lamp.values, Affine::translation({0, 0, 2.5}));
        const CommittedScene scene = kit.commit();
        const PathKit path(scene, {{"depth", 1}});
        Moments direct, indirect;
        path.along({-1, -0.6, 0.9}, {1, 0.4, -0.9}, 150 * test::batch, [&](const LightParts& parts) {
            direct.add(static_cast<double>(parts.direct.g));
            EXPECT_EQ(parts.sum(), parts.direct);
        });
        const Moments wanted = PathKit(scene).at_point({-1, -0.6, 0.9}, {1, 0.4, -0.9}, 150 * test::batch).direct;
        expect_mean(direct, wanted.mean(), lamp.kind, wanted.error());
    }
}

TEST(PathAgreement, OfOneLightChosenAmongManyWithTheSumOfAll) {
    SceneKit kit;
    double wanted = 0;
    kit.root(kit.box({-9, -9, -1}, {9, 9, 0}, 0));
    for (int i = 0; i < 40; ++i) {
        const Vec3d at{i % 7 - 3.0, i % 5 - 2.0, 1.0 + i % 3};
        const double intensity = 1 + i % 4;
        kit.light("point_light", {{"intensity", {intensity}}}, Affine::translation(at));
        const double d2 = dot(at, at);
        wanted += intensity * at.z / (d2 * std::sqrt(d2));
    }
    kit.light("sun", {{"direction", {0, 0, -1}}, {"irradiance", {0.5}}});
    const CommittedScene scene = kit.commit();
    wanted += 0.5;
    const PathKit path(scene, {{"depth", 1}});
    expect_mean(path.radiance({0, 0, 0.5}, {0, 0, -1}, 100 * test::batch), wanted * 0.5 / std::numbers::pi, "lamps");
}

}  // namespace
}  // namespace cardioid
