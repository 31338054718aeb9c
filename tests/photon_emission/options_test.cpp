#include <cstring>
#include <gtest/gtest.h>
#include <set>

#include "photon/options/choice_names.hpp"
#include "photon/options/photon_options.hpp"
#include "rt_core/api/registry.hpp"

namespace cardioid {
namespace {

using photon::PhotonOptions;
using photon::read_photon_options;

Params with(const std::string& name, ParamValue value) {
    Params params("room.csg:3:1");
    params.set(name, std::move(value));
    return params;
}
ParamValue number(double x) { return {.numbers = {x}}; }
ParamValue text(const std::string& t) { return {.kind = ParamValue::Kind::text, .text = t}; }

/// What reading it says, or nothing.
std::string refusal(const Params& params) {
    try {
        static_cast<void>(read_photon_options(params));
        return {};
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::bad_input);
        return error.what();
    }
}

TEST(PhotonOptions, AreThoseOfPhysicsWhereNothingIsSaid) {
    const PhotonOptions o = read_photon_options({});
    EXPECT_EQ(o.mode, photon::Mode::physical);
    EXPECT_FALSE(o.count || o.caustic_count || o.k || o.radius || o.memory);
    EXPECT_EQ(o.roulette, photon::Roulette::flux);
    EXPECT_EQ(o.indirect, photon::Indirect::cache);
    EXPECT_FALSE(o.rr_double_count || o.half_jitter || o.count_last);
}

TEST(PhotonOptions, OfTheReportAreItsColumnOfTheTable) {
    const PhotonOptions o = read_photon_options(with("mode", text("report")));
    EXPECT_TRUE(o.count_by_faces && o.fixed_radius && o.count_last && o.half_jitter);
    EXPECT_EQ(o.directions, photon::Directions::ball);
    EXPECT_EQ(o.kernel, photon::Kernel::box);
    EXPECT_EQ(o.edge, photon::EdgeRule::report);
    EXPECT_EQ(o.indirect, photon::Indirect::precomputed);
    EXPECT_EQ(o.hemisphere, (std::array{6, 13}));
    EXPECT_EQ(o.cache_every, 4);
    EXPECT_EQ(o.cache_nearest, 50);
    EXPECT_FALSE(o.aim_caustics);
}

TEST(PhotonOptions, SetOneItemOfAPresetAlone) {
    Params params = with("mode", text("report"));
    params.set("edge", text("none"));
    params.set("count", 5000.0);
    params.set("hemisphere", ParamValue{.numbers = {8, 20}, .list = true});
    const PhotonOptions o = read_photon_options(params);
    EXPECT_EQ(o.edge, photon::EdgeRule::none);
    EXPECT_EQ(o.count, 5000U);
    EXPECT_EQ(o.hemisphere, (std::array{8, 20}));
    EXPECT_EQ(o.kernel, photon::Kernel::box);
}

TEST(PhotonOptions, AreRefusedWithThePlaceAndWhatIsWanted) {
    EXPECT_NE(refusal(with("kernel", text("konus"))).find("room.csg:3:1: kernel must be one of \"box\", \"cone\""),
              std::string::npos);
    EXPECT_NE(refusal(with("count", number(0))).find("count = 0 must be between 1"), std::string::npos);
    EXPECT_NE(refusal(with("count", number(1.5))).find("count must be a whole number"), std::string::npos);
    EXPECT_NE(refusal(with("radius", number(-1))).find("radius must be above 0"), std::string::npos);
    EXPECT_NE(refusal(with("error", number(2))).find("error = 2 must be between 0.001 and 1"), std::string::npos);
    EXPECT_NE(refusal(with("k", number(1))).find("k = 1 must be between 2"), std::string::npos);
    EXPECT_NE(refusal(with("hemisphere", number(5))).find("hemisphere must be a list of 2"), std::string::npos);
    EXPECT_NE(refusal(with("mode", number(1))).find("mode must be a text"), std::string::npos);
    EXPECT_EQ(refusal(with("caustic_count", number(0))), "");
}

TEST(PhotonOptions, HaveEveryNameOnceWithHelp) {
    std::set<std::string> names;
    for (const ParamSpec& param : photon::photon_params()) {
        EXPECT_TRUE(names.insert(param.name).second) << param.name;
        EXPECT_GT(std::strlen(param.help), 10U);
    }
}

// What the table says is the default is what reading nothing gives.
TEST(PhotonOptions, OfTextHaveTheDefaultOfTheTable) {
    const PhotonOptions o;
    for (const ParamSpec& param : photon::photon_params()) {
        const std::string name = param.name;
        const auto is = [&](const char* option, auto choice) {
            if (name != option) return;
            EXPECT_STREQ(param.fallback, photon::name_of(choice)) << name;
        };
        is("mode", o.mode);
        is("directions", o.directions);
        is("shares", o.shares);
        is("roulette", o.roulette);
        is("store", o.store);
        is("kernel", o.kernel);
        is("caustic_kernel", o.caustic_kernel);
        is("edge", o.edge);
        is("indirect", o.indirect);
        is("strata", o.strata);
    }
}

}  // namespace
}  // namespace cardioid
