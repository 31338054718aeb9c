/// Caustics on glossy places: photons and rays share each way of light, and both together are all of it.
#include <fmt/format.h>

#include "glossy_kit.hpp"

namespace cardioid {
namespace {

using test::find;
using test::Found;
using test::Look;
using test::SceneKit;

/// Whether an area lamp, or a spot in its place, shines at the wall.
enum class Source { area, spot };

constexpr Vec3d lamp_at{0, 0, 1.5};
constexpr double lamp_side = 0.4, lamp_power = 5, spot_intensity = 4;

void add_lamp(SceneKit& kit, Source source) {
    if (source == Source::area)
        kit.light("area_light", {{"size", {lamp_side, lamp_side}}, {"power", {lamp_power}}},
                  test::towards_wall(lamp_at));
    else
        kit.light("spot_light", {{"intensity", {spot_intensity}}, {"angle", {60}}, {"inner", {50}}},
                  test::towards_wall(lamp_at));
}

/// What a mirror at y = 1 brings to a place from the lamp's image: its solid angle by midpoints.
double mirrored(const SurfacePoint& point, const Bsdf& bsdf, Vec3 wo, Source source, double reflectance) {
    const Vec3d image{lamp_at.x, 2 - lamp_at.y, lamp_at.z};
    const int n = source == Source::area ? 64 : 1;
    double L = 0;
    for (int i = 0; i < n * n; ++i) {
        const double x = ((i % n + 0.5) / n - 0.5) * lamp_side, z = ((i / n + 0.5) / n - 0.5) * lamp_side;
        const Vec3d way = image + (n > 1 ? Vec3d{x, 0, z} : Vec3d{}) - point.p;
        const double d = length(way);
        const double cosine = way.z / d, facing = way.y / d;
        const double power = source == Source::area ? lamp_power / std::numbers::pi * facing : spot_intensity;
        const Vec3 wi = point.frame.to_local(Vec3(way / d));
        L += double{bsdf.f(point.frame.to_local(wo), wi).g} * cosine / (d * d) * power / (n * n);
    }
    return L * reflectance;
}

/// The mean of all places.
double mirrored(const CommittedScene& scene, const Look& look, Source source, double reflectance) {
    double sum = 0;
    look.each(scene, [&](const SurfacePoint& point, const Bsdf& bsdf, Vec3 wo, std::uint32_t) {
        sum += mirrored(point, bsdf, wo, source, reflectance) / 25;
    });
    return sum;
}

CommittedScene mirror_scene(SceneKit kit, Source source) {
    test::add_wall(kit, kit.material("mirror", "mirror", {{"reflectance", {0.8}}}));
    add_lamp(kit, source);
    return kit.commit();
}

/// A lamp and how rough the plate is.
struct Case {
    Source source;
    double roughness;
};

TEST(GlossyCaustics, OfAMirrorAreAsBrightAsTheImageOfTheLamp) {
    for (const Case& c : {Case{Source::area, 0.3}, {Source::area, 0.45}, {Source::spot, 0.7}}) {
        const CommittedScene scene = mirror_scene(test::plate("conductor", {{"roughness", {c.roughness}}}), c.source);
        const Found found = find(scene, {}, 40, c.source == Source::area ? 50'000 : 15'000, 16);
        test::expect_mean(found.mean, mirrored(scene, {}, c.source, 0.8),
                          fmt::format("roughness {} lamp {}", c.roughness, static_cast<int>(c.source)));
    }
}

TEST(GlossyCaustics, OnDiffuseAndShinySurfacesHaveBothParts) {
    for (const Source source : {Source::area, Source::spot}) {
        const CommittedScene scene =
            mirror_scene(test::plate("phong", {{"diffuse", {0.4}}, {"specular", {0.5}}, {"exponent", {30}}}), source);
        const Found found = find(scene, {}, 40, source == Source::area ? 100'000 : 15'000, 4);
        test::expect_mean(found.mean, mirrored(scene, {}, source, 0.8),
                          fmt::format("lamp {}", static_cast<int>(source)));
    }
}

// Where photons come from all of a large lamp few of them are within a narrow lobe.
TEST(GlossyCaustics, OfALargeLampScatterLessThanPhotonsAlone) {
    const CommittedScene scene = mirror_scene(test::plate("conductor", {{"roughness", {0.2}}}), Source::area);
    const Found found = find(scene, {}, 40, 5'000, 32);
    EXPECT_LT(found.variance, found.variance_of_maps / 8);
}

TEST(GlossyCaustics, ThroughAGlassBallAreWhatPathsFind) {
    SceneKit kit = test::plate("conductor", {{"roughness", {0.4}}});
    kit.root(kit.ball({0, 0.4, 1.4}, 0.8, kit.material("glass", "dielectric", {{"ior", {1.5}}})));
    kit.light("area_light", {{"size", {1, 1}}, {"power", {5}}}, Affine::translation({0, 0.8, 3.5}));
    const CommittedScene scene = kit.commit();
    const Look look{.towards = {0, 0.8, 3.5}, .side = 0.6};
    const test::Moments wanted = test::by_paths(scene, look, 40);
    test::expect_mean(find(scene, look, 40, 60'000).mean, wanted.mean(), "glass ball", wanted.error());
}

TEST(GlossyCaustics, FromRoughMetalToRoughMetalAreWhatPathsFind) {
    for (const Case& c : {Case{Source::spot, 0.37}, {Source::area, 0.6}, {Source::spot, 0.7}}) {
        SceneKit kit = test::plate("conductor", {{"roughness", {0.5}}});
        test::add_wall(kit, kit.material("wall", "conductor", {{"roughness", {c.roughness}}}));
        add_lamp(kit, c.source);
        const CommittedScene scene = kit.commit();
        const test::Moments wanted = test::by_paths(scene, {}, 80);
        test::expect_mean(find(scene, {}, 80, 40'000, 32).mean, wanted.mean(),
                          fmt::format("roughness {} lamp {}", c.roughness, static_cast<int>(c.source)), wanted.error());
    }
}

// The photons of what a rough pane lets through come to its other side.
TEST(GlossyCaustics, ThroughARoughPaneAreWhatPathsFind) {
    SceneKit kit;
    kit.root(kit.box({-3, -3, 0}, {3, 3, 0.4}, kit.material("pane", "dielectric", {{"roughness", {0.45}}})));
    kit.light("area_light", {{"size", {1.5, 1.5}}, {"power", {5}}}, Affine::translation({0, 0, 2}));
    const CommittedScene scene = kit.commit();
    const Look look{.towards = {0, 0, 2}, .behind = true};
    const test::Moments wanted = test::by_paths(scene, look, 40);
    test::expect_mean(find(scene, look, 40, 5'000, 32).mean, wanted.mean(), "pane", wanted.error());
}

}  // namespace
}  // namespace cardioid
