#include "photon/heuristics/plan.hpp"

#include <gtest/gtest.h>

#include "emission_kit.hpp"

#include "photon/heuristics/counts.hpp"
#include "photon/map/photon_map.hpp"

namespace cardioid {
namespace {

using photon::PhotonOptions;
using photon::Plan;
using test::SceneKit;

Plan plan_of(const SceneKit& kit, const PhotonOptions& options = {}) {
    Progress progress;
    return photon::make_plan(kit.commit(), nullptr, options, 1, progress);
}

SceneKit plain_room(double size = 1) {
    SceneKit kit;
    const Vec3d s = Vec3d{1, 1, 1} * size;
    const auto wall = kit.material("wall", "diffuse", {{"reflectance", {0.5, 0.5, 0.5}}});
    kit.root(kit.scene.solids.add_node(SolidOp::subtract, {kit.box(-s, s * 2.0, wall), kit.box({}, s, wall)}));
    kit.light("point_light", {{"power", {1, 1, 1}}}, Affine::translation(s * 0.5));
    return kit;
}

const photon::Derived* note(const Plan& plan, const std::string& name) {
    for (const photon::Derived& d : plan.derived)
        if (d.name == name) return &d;
    return nullptr;
}

TEST(Counts, FollowTheReportsRule) {
    EXPECT_EQ(photon::report_count(0), 10'000U);
    EXPECT_EQ(photon::report_count(99), 10'000U);
    EXPECT_EQ(photon::report_count(100), 10'001U);
    EXPECT_EQ(photon::report_count(1'000'000), 20'000U);
}

TEST(Counts, FollowTheErrorThatIsWanted) {
    EXPECT_EQ(photon::lookup_size(0.05), 402U);
    EXPECT_EQ(photon::lookup_size(0.1), 102U);
    EXPECT_EQ(photon::lookup_size(1), 3U);
    // N = k A / (pi r^2) for an area of 6 that one photon in two is stored on.
    EXPECT_NEAR(photon::count_for(50, 0.1, 2.0 / 6), 50 * 6 / (std::numbers::pi * 0.01) / 2, 1e-6);
    EXPECT_EQ(photon::count_for(50, 0.1, 0), 0);
}

TEST(Plan, OfAPlainRoomKnowsWhatIsStoredAndThatThereAreNoCaustics) {
    const Plan plan = plan_of(plain_room());
    EXPECT_NEAR(plan.stored_per_emitted, 2, 0.1);  // 1 / (1 - 0.5)
    EXPECT_EQ(plan.caustic_count, 0U);
    EXPECT_EQ(plan.specular_share, 0);
    ASSERT_TRUE(note(plan, "caustic_count"));
    EXPECT_EQ(note(plan, "caustic_count")->value, "0");
    for (const char* name : {"count", "k", "radius", "stored_per_emitted"}) EXPECT_TRUE(note(plan, name)) << name;
}

// The count it finds does what it was found for: so many photons within the radius at most places.
TEST(Plan, FindsACountThatFillsLookups) {
    PhotonOptions options;
    options.k = 100;
    options.radius = 0.05;
    const SceneKit kit = plain_room();
    const Plan plan = plan_of(kit, options);
    EXPECT_EQ(plan.k, 100U);
    EXPECT_EQ(plan.radius, 0.05);
    EXPECT_FALSE(note(plan, "radius"));
    // 6 of area, 2 stored an emitted photon: even light would want 100 / (pi r^2) 6 / 2.
    const double even = 100 / (std::numbers::pi * 0.0025) * 3;
    EXPECT_GT(static_cast<double>(plan.count), 0.8 * even);
    EXPECT_LT(static_cast<double>(plan.count), 2.5 * even);
    const photon::Shot shot = test::shoot(kit.commit(), plan.count);
    const photon::PhotonMap map(shot.photons, shot.origin, shot.flux_scale);
    int full = 0, places = 0;
    for (double x = 0.1; x < 1; x += 0.1)
        for (double y = 0.1; y < 1; y += 0.1, ++places) {
            SurfacePoint point;
            point.p = {x, y, 0};
            point.ng = {0, 0, 1};
            point.frame = Frame(point.ng);
            full += map.irradiance(point, point.ng, {.k = 100}).radius < 0.05F;
        }
    EXPECT_GT(full, 0.6 * places);
    EXPECT_LE(full, places);
}

TEST(Plan, DoesNotDependOnTheUnitOfLength) {
    const Plan small = plan_of(plain_room(1)), large = plan_of(plain_room(1024));
    EXPECT_NEAR(static_cast<double>(small.count) / static_cast<double>(large.count), 1, 1e-3);
    EXPECT_NEAR(large.radius / small.radius, 1024, 1e-6);
}

TEST(Plan, OfAGlassBallShootsCausticPhotons) {
    SceneKit kit = plain_room();
    kit.root(kit.ball({0.5, 0.5, 0.2}, 0.15, kit.material("glass", "dielectric", {{"ior", {1.5}}})));
    const Plan plan = plan_of(kit);
    EXPECT_GT(plan.caustic_count, 10'000U);
    EXPECT_GT(plan.caustic_share, 0.01);
    EXPECT_GT(plan.specular_share, 0.01);
    EXPECT_FALSE(plan.aim.cells.empty());
    EXPECT_LT(plan.caustic_radius, plan.radius);
    PhotonOptions none;
    none.caustic_count = 0;
    EXPECT_EQ(plan_of(kit, none).caustic_count, 0U);
    // The finer the caustics, the more photons; sent everywhere, many more are needed.
    PhotonOptions fine, even;
    fine.caustic_radius = even.caustic_radius = 0.002;
    even.aim_caustics = false;
    const Plan aimed = plan_of(kit, fine), unaimed = plan_of(kit, even);
    EXPECT_GT(aimed.caustic_count, plan.caustic_count);
    EXPECT_TRUE(unaimed.aim.cells.empty());
    EXPECT_GT(unaimed.caustic_count, 2 * aimed.caustic_count);
}

std::uint64_t count_of_picture(double reflectance, double error, int side) {
    SceneKit kit = test::lit_room("diffuse", {{"reflectance", {reflectance, reflectance, reflectance}}});
    const CommittedScene world = kit.commit();
    const test::StaringEye eye(world, {{0.5, 0.5, 0.5}, {0, 0, -1}}, side);
    PhotonOptions options;
    options.radius = 0.005;
    options.error = error;
    Progress progress;
    return photon::make_plan(world, &eye, options, 1, progress).count;
}

// What is gathered is indirect light: its noise counts for less where lamps do most. Of n photons that fall in a closed
// room 1 - n / (n + n r + n r^2 + ...) = r are indirect, and 1 / (1 - r) fall for each that is emitted.
TEST(Plan, OfAPictureFollowsTheShareOfIndirectLight) {
    const auto bright = static_cast<double>(count_of_picture(0.5, 0.05, 8)),
               dim = static_cast<double>(count_of_picture(0.2, 0.05, 8));
    EXPECT_NEAR(bright / dim, 0.5 * (1 - 0.5) / (0.2 * (1 - 0.2)), 0.6);
    EXPECT_GT(bright, 20'000);
}

TEST(Plan, OfAPictureFollowsTheErrorThatIsWantedAndIsBoundedBySize) {
    const std::uint64_t usual = count_of_picture(0.2, 0.05, 8), draft = count_of_picture(0.2, 0.1, 8);
    EXPECT_NEAR(static_cast<double>(usual) / static_cast<double>(draft), 4, 0.01);
    EXPECT_EQ(count_of_picture(0.2, 0.01, 8), 400'000U);
    EXPECT_NEAR(static_cast<double>(count_of_picture(0.2, 0.02, 1000)) / static_cast<double>(usual), 6.25, 0.01);
    EXPECT_EQ(count_of_picture(0.2, 0.001, 1000), 4'000'000U);
}

TEST(Plan, OfTheReportCountsFaces) {
    const Params params = [] {
        Params p;
        p.set("mode", std::string("report"));
        return p;
    }();
    const Plan plan = plan_of(plain_room(), photon::read_photon_options(params));
    EXPECT_EQ(plan.count, 10'000U);
    EXPECT_EQ(note(plan, "count")->why.substr(0, 8), "10,000 +");
    EXPECT_EQ(plan.k, 402U);
}

TEST(Plan, RefusesCountsThatMemoryCannotHoldAndBoundsItsOwn) {
    PhotonOptions options;
    options.memory = 100e6;
    options.count = 100'000'000;
    try {
        static_cast<void>(plan_of(plain_room(), options));
        FAIL() << "10^8 photons in 100 MB";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::limit);
        const std::string what = error.what();
        EXPECT_NE(what.find("photon.count: 100000000 photons store about "), std::string::npos) << what;
        EXPECT_NE(what.find(" and need 14"), std::string::npos) << what;
        EXPECT_NE(what.find("photon.memory is 100 MB"), std::string::npos) << what;
    }
    options.count.reset();
    options.memory = 1e6;
    const Plan plan = plan_of(plain_room(), options);
    EXPECT_LT(plan.count, 8000U);
    EXPECT_GT(plan.count, 5000U);
}

TEST(Plan, OfADarkSceneIsSmallAndFinite) {
    SceneKit kit;
    kit.root(kit.box({0, 0, 0}, {1, 1, 1}, 0));
    const Plan plan = plan_of(kit);
    EXPECT_EQ(plan.caustic_count, 0U);
    EXPECT_LE(plan.count, 20'000U);
    EXPECT_GT(plan.radius, 0);
}

}  // namespace
}  // namespace cardioid
