#include "photon/file/shape_text.hpp"

#include <fmt/format.h>

#include "photon/options/choice_names.hpp"

namespace cardioid::photon {

namespace {

template <class Number>
std::string given(const std::optional<Number>& number) {
    return number ? fmt::format("{}", *number) : "automatic";
}

}  // namespace

std::string shape_text(const PhotonOptions& o, std::uint32_t seed) {
    std::string text;
    const auto line = [&](const char* name, const auto& value) { text += fmt::format("{} = {}\n", name, value); };
    line("seed", seed);
    line("count", given(o.count));
    line("caustic_count", given(o.caustic_count));
    line("count_by_faces", o.count_by_faces);
    line("error", o.error);
    line("directions", name_of(o.directions));
    line("shares", name_of(o.shares));
    line("roulette", name_of(o.roulette));
    line("rr_double_count", o.rr_double_count);
    line("store", name_of(o.store));
    line("aim_caustics", o.aim_caustics);
    line("k", given(o.k));
    line("radius", given(o.radius));
    line("kernel", name_of(o.kernel));
    line("fixed_radius", o.fixed_radius);
    line("count_last", o.count_last);
    line("normal_tolerance", o.normal_tolerance);
    line("edge", name_of(o.edge));
    line("indirect", name_of(o.indirect));
    line("hemisphere", fmt::format("{}, {}", o.hemisphere[0], o.hemisphere[1]));
    line("strata", name_of(o.strata));
    line("half_jitter", o.half_jitter);
    line("cache_every", o.cache_every);
    return text;
}

}  // namespace cardioid::photon
