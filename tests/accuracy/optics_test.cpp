/// Facts of geometrical and Fresnel optics (A5, A6), by rays that are traced through CSG solids with the hooks that
/// rendering uses: the tracer's hits and media, the material's choice of direction and its shares.
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/accuracy/formulas/formulas.hpp"
#include "tests/accuracy/light_ray.hpp"
#include "tests/accuracy/lit_scene.hpp"

namespace cardioid::test {
namespace {

using enum Turn;

constexpr double angle_tolerance = 0.02;  // degrees

CommittedScene of_index(const char* file, const char* in_file, double index) {
    return commit(sample_scene(file, {{in_file, fmt::format("ior = {}", index)}}));
}
CommittedScene plate(double index) { return of_index("accuracy/optics/slab.csg", "ior = 1.52", index); }
CommittedScene prism(double index) { return of_index("accuracy/optics/prism.csg", "ior = 1.5168", index); }
/// A ball of radius 1 around (0, 0, 1.5).
CommittedScene ball(double index) { return of_index("accuracy/caustics/ball_lens.csg", "ior = 1.5", index); }

/// Down to the plate's top or up to its bottom, at an angle to its normal.
Vec3d down(double deg) { return {std::sin(deg * degree), 0, -std::cos(deg * degree)}; }

struct Reflectance {
    double index, at_0, at_30, at_45, at_60, at_75, at_85;
};

TEST(Plate, ReflectsByFresnelsEquations) {
    // Computed for this test from the equations; n = 1.333, 1.5 and 1.52 also stand in Hecht, "Optics", 4.6.
    for (const Reflectance& r : {Reflectance{1.333, .020373, .021436, .027898, .059691, .212378, .583523},
                                 Reflectance{1.5, .04, .041523, .050240, .089187, .253061, .612800},
                                 Reflectance{1.52, .042580, .044144, .053045, .092483, .256715, .614923}}) {
        const CommittedScene scene = plate(r.index);
        const auto reflected = [&](double deg) { return follow(scene, {0, 0, 2}, down(deg), {reflect}).share; };
        EXPECT_NEAR(reflected(0), r.at_0, 1e-5);
        EXPECT_NEAR(reflected(30), r.at_30, 1e-5);
        EXPECT_NEAR(reflected(45), r.at_45, 1e-5);
        EXPECT_NEAR(reflected(60), r.at_60, 1e-5);
        EXPECT_NEAR(reflected(75), r.at_75, 1e-5);
        EXPECT_NEAR(reflected(85), r.at_85, 1e-5);
    }
    EXPECT_NEAR(follow(plate(1.65), {0, 0, 2}, down(0), {reflect}).share, 0.060164, 1e-5);
}

TEST(Plate, ReflectsEvenLightFromBothSidesAsItsIntegralHasIt) {
    struct Even {
        double index, outside, inside;
    };
    for (const Even& even :
         {Even{1.333, .066406, .474591}, Even{1.5, .091778, .596346}, Even{1.52, .094707, .608166}}) {
        const CommittedScene scene = plate(even.index);
        double outside = 0, inside = 0;
        constexpr int steps = 4000;
        for (int i = 0; i < steps; ++i) {
            const double c = std::sqrt((i + 0.5) / steps);
            const Vec3d d{std::sqrt(1 - c * c), 0, -c};
            outside += follow(scene, {0, 0, 2}, d, {reflect}).share / steps;
            inside += follow(scene, {0, 0, 0.25}, d, {reflect}).share / steps;
        }
        EXPECT_NEAR(outside, even.outside, 2e-5);
        EXPECT_NEAR(inside, even.inside, 2e-4);  // the reflectance has a kink at the critical angle
    }
}

TEST(Plate, LetsThroughWhatAllItsInnerReflectionsAddUpTo) {
    for (const double index : {1.333, 1.52, 1.9})
        for (const double deg : {0.0, 30.0, 45.0, 60.0, 75.0, 85.0}) {
            const CommittedScene scene = plate(index);
            double through = 0;
            std::vector<Turn> turns{refract};
            for (int inner = 0; inner < 60; inner += 2) {
                turns.push_back(refract);
                through += follow(scene, {0, 0, 2}, down(deg), turns).share;
                turns.back() = reflect;
                turns.push_back(reflect);
            }
            const double r = unpolarised(std::cos(deg * degree), index);
            EXPECT_NEAR(through, (1 - r) / (1 + r), 1e-5) << index << " " << deg;
        }
}

/// Light loses its polarisation at each surface of this tracer; if it were kept, a plate of index 1.52 would let
/// through 0.3 % more at 45 degrees and 1.8 % more at 75. This tells by how much the model is off, not that it is
/// right.
TEST(Plate, IsDarkerThanWithPolarisationByAKnownShare) {
    const auto kept = [](double deg) {
        const auto [s, p] = fresnel(std::cos(deg * degree), 1.52);
        return ((1 - s) / (1 + s) + (1 - p) / (1 + p)) / 2;
    };
    const auto lost = [](double deg) {
        const double r = unpolarised(std::cos(deg * degree), 1.52);
        return (1 - r) / (1 + r);
    };
    EXPECT_NEAR(kept(45), 0.90253, 1e-5);
    EXPECT_NEAR(lost(45), 0.89925, 1e-5);
    EXPECT_NEAR(kept(0), lost(0), 1e-12);
}

TEST(Plate, DisplacesRaysWithoutTurningThem) {
    const CommittedScene scene = plate(1.52);
    for (const double deg : {10.0, 50.0, 80.0}) {
        const LightRay light = follow(scene, {0, 0, 2}, down(deg), {refract, refract});
        ASSERT_FALSE(light.gone);
        EXPECT_NEAR(angle_between(light.d, down(deg)), 0, 1e-4);
        const double inside = std::asin(std::sin(deg * degree) / 1.52);
        EXPECT_NEAR(light.o.x, 1.5 * std::tan(deg * degree) + 0.5 * std::tan(inside), 1e-5);
    }
}

TEST(Plate, HasBrewstersAndTheCriticalAngle) {
    struct Angles {
        double index, brewster, critical;
    };
    for (const Angles& angles :
         {Angles{1.5, 56.3099, 41.8103}, Angles{1.333, 53.1230, 48.6066}, Angles{2.4, 67.3801, 24.6243}}) {
        const CommittedScene scene = plate(angles.index);
        // At Brewster's angle what is reflected and what is bent are at right angles.
        const auto acute = [&](double deg) {
            const LightRay up = follow(scene, {0, 0, 2}, down(deg), {reflect});
            const LightRay into = follow(scene, {0, 0, 2}, down(deg), {refract});
            return angle_between(up.d, into.d) > 90;
        };
        EXPECT_NEAR(border(acute, 0, 90), angles.brewster, angle_tolerance);
        const auto leaves = [&](double deg) { return !follow(scene, {0, 0, 0.25}, down(deg), {refract}).gone; };
        EXPECT_NEAR(border(leaves, 0, 90), angles.critical, angle_tolerance);
    }
}

/// Least deviation [deg] of rays in the prism's plane, over their angle to the normal of its left face.
double least_deviation(double index) {
    const CommittedScene scene = prism(index);
    const auto deviation = [&](double deg) {
        const double heading = (deg - 30) * degree;
        const Vec3d d{std::cos(heading), std::sin(heading), 0};
        const LightRay light = follow(scene, Vec3d(-0.5, 0.8660254, 0.5) - d, d, {refract, refract});
        return light.gone ? 180 : angle_between(light.d, d);
    };
    return deviation(least_at(deviation, 35, 85));
}

TEST(Prism, DeviatesTheColoursOfTwoGlasses) {
    struct Line {
        double index, least_deg;
    };
    // Schott's indices of N-BK7 and N-SF11 at 404.66, 486.13, 587.56 and 656.27 nm.
    for (const Line& line :
         {Line{1.530240, 39.8353}, Line{1.522376, 39.1381}, Line{1.516800, 38.6467}, Line{1.514322, 38.4291},
          Line{1.842352, 74.1973}, Line{1.806513, 69.1789}, Line{1.784720, 66.3426}, Line{1.775955, 65.2404}}) {
        const double found = least_deviation(line.index);
        EXPECT_NEAR(found, line.least_deg, angle_tolerance) << line.index;
        EXPECT_NEAR(found, 2 * std::asin(line.index / 2) / degree - 60, 1e-3) << line.index;
    }
}

/// Radius [deg] of the rainbow after `inner` reflections in a drop: the extreme angle to the point opposite the sun.
double bow_radius(double index, int inner) {
    const CommittedScene scene = ball(index);
    std::vector<Turn> turns(static_cast<std::size_t>(inner) + 2, reflect);
    turns.front() = turns.back() = refract;
    const auto radius = [&](double height) {
        const LightRay light = follow(scene, {height, 0, 4}, {0, 0, -1}, turns);
        return angle_between(light.d, {0, 0, 1});
    };
    const double sign = inner == 1 ? -1 : 1;  // the first bow is the largest angle, the second the least
    return radius(least_at([&](double height) { return sign * radius(height); }, 0.6, 0.999));
}

TEST(Raindrop, ShowsBothRainbowsAtTheirRadii) {
    struct Bows {
        double index, first_deg, second_deg;
    };
    for (const Bows& bows :
         {Bows{1.3311, 42.3552, 50.3915}, Bows{1.333, 42.0781, 50.8908}, Bows{1.3435, 40.5754, 53.6053}}) {
        EXPECT_NEAR(bow_radius(bows.index, 1), bows.first_deg, angle_tolerance) << bows.index;
        EXPECT_NEAR(bow_radius(bows.index, 2), bows.second_deg, angle_tolerance) << bows.index;
    }
}

TEST(BallLens, BringsRaysToTheAxisWhereSnellHasIt) {
    struct Crossing {
        double height, distance;
    };
    const CommittedScene scene = ball(1.5);
    for (const Crossing& crossing : {Crossing{.05, 1.49896}, Crossing{.2, 1.48323}, Crossing{.4, 1.43164},
                                     Crossing{.6, 1.34078}, Crossing{.8, 1.20028}, Crossing{.95, 1.04806}}) {
        const LightRay light = follow(scene, {crossing.height, 0, 4}, {0, 0, -1}, {refract, refract});
        EXPECT_NEAR(1.5 - (light.o.z - light.o.x * light.d.z / light.d.x), crossing.distance, 1e-4);
    }
}

TEST(BallLens, GathersFluxInDiscs) {
    struct Disc {
        double index, distance, radius;
    };
    for (const Disc& disc :
         {Disc{1.5, 1.2, .05}, Disc{1.5, 1.2, .2}, Disc{1.5, 1.5, .05}, Disc{1.5, 1.5, .5}, Disc{1.333, 2, .1}}) {
        const CommittedScene scene = ball(disc.index);
        constexpr int rays = 20'000;
        double flux = 0;
        for (int i = 0; i < rays; ++i) {
            const LightRay light = follow(scene, {std::sqrt((i + 0.5) / rays), 0, 4}, {0, 0, -1}, {refract, refract});
            const double s = (1.5 - disc.distance - light.o.z) / light.d.z;
            if (!light.gone && std::abs(light.o.x + s * light.d.x) < disc.radius) flux += light.share / rays;
        }
        const double args[] = {disc.index, disc.distance, disc.radius};
        const double expected = known_formula("ball_lens", args) * disc.radius * disc.radius;
        EXPECT_NEAR(flux, expected, 2e-3 * expected) << disc.distance << " " << disc.radius;
    }
}

/// Distance along the reflected ray to where its neighbours cross it: a point of the caustic.
double caustic_distance(const CommittedScene& scene, Vec3d o, double heading) {
    constexpr double aside = 2e-4;
    const auto reflected = [&](double a) { return follow(scene, o, {std::cos(a), std::sin(a), 0}, {reflect}); };
    const LightRay a = reflected(heading - aside), b = reflected(heading + aside), middle = reflected(heading);
    const Vec3d across = cross(a.d, b.d);
    const double s = dot(cross(b.o - a.o, b.d), across) / dot(across, across);
    return length(a.o + a.d * s - middle.o);
}

TEST(RingMirror, DrawsTheCaustic) {
    const CommittedScene scene = commit(sample_scene("accuracy/caustics/cardioid.csg"));
    int real = 0;
    for (const double from : {-0.9999, -0.5, 0.2})
        for (const double heading : {0.1, 0.5, 0.9}) {
            const Vec3d o{from, 0, 0.5}, d{std::cos(heading), std::sin(heading), 0};
            const LightRay light = follow(scene, o, d, {reflect});
            // 1/s + 1/s' = 2/(R cos i) at a circle.
            const double back = 2 / light.last_cosine - 1 / length(light.o - o);
            if (back < 0.5) continue;  // the caustic is far away, or virtual
            ++real;
            EXPECT_NEAR(caustic_distance(scene, o, heading), 1 / back, 1e-3) << from << " " << heading;
        }
    EXPECT_GE(real, 6);
}

}  // namespace
}  // namespace cardioid::test
