#include "photon/options/photon_options.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "photon/options/choice_names.hpp"

namespace cardioid::photon {

namespace {

/// Sets options from parameters; what is not given stays as it is.
class Reader {
public:
    explicit Reader(const Params& params) : params_(params) {}

    template <class Choice>
    requires std::is_enum_v<Choice>
    void read(const char* name, Choice& option) const {
        if (!params_.has(name)) return;
        const std::string text = params_.text(name);
        std::string wanted;
        for (const auto& [known, choice] : names_of(Choice{})) {
            if (text == known) {
                option = choice;
                return;
            }
            wanted += (wanted.empty() ? "\"" : ", \"") + std::string(known) + '"';
        }
        params_.wrong(name, "one of " + wanted + "; found \"" + text + '"');
    }
    void read(const char* name, bool& option) const { option = params_.boolean(name, option); }
    void read(const char* name, double& option, double lo, double hi) const {
        option = params_.number(name, option, lo, hi);
    }
    void read(const char* name, int& option, int lo, int hi) const { option = whole<int>(name, option, lo, hi); }
    template <class Whole>
    void read(const char* name, std::optional<Whole>& option, double lo, double hi) const {
        if (params_.has(name)) option = whole<Whole>(name, Whole{}, lo, hi);
    }
    void read_above_zero(const char* name, std::optional<double>& option) const {
        if (!params_.has(name)) return;
        option = params_.number(name, 0);
        if (*option <= 0) params_.wrong(name, "above 0");
    }
    void read(const char* name, std::array<int, 2>& option) const {
        const auto pair = params_.vector(name, 2);
        if (!pair) return;
        for (std::size_t i = 0; i < 2; ++i) {
            const double x = (*pair)[i];
            if (x < 1 || x > 1000 || x != std::floor(x)) params_.wrong(name, "two whole numbers from 1 to 1000");
            option[i] = static_cast<int>(x);
        }
    }

private:
    template <class Whole>
    [[nodiscard]] Whole whole(const char* name, Whole fallback, double lo, double hi) const {
        const double x = params_.number(name, static_cast<double>(fallback), lo, hi);
        if (x != std::floor(x)) params_.wrong(name, "a whole number");
        return static_cast<Whole>(x);
    }
    const Params& params_;
};

/// The column "photon.mode=report" of what the report does, its pitfalls included.
PhotonOptions report_options() {
    PhotonOptions o;
    o.mode = Mode::report;
    o.count_by_faces = true;
    o.directions = Directions::ball;
    o.shares = Shares::even;
    o.roulette = Roulette::mean;
    o.aim_caustics = false;
    o.kernel = o.caustic_kernel = Kernel::box;
    o.fixed_radius = true;
    o.count_last = true;
    o.edge = EdgeRule::report;
    o.indirect = Indirect::precomputed;
    o.hemisphere = {6, 13};
    o.half_jitter = true;
    o.strata = Strata::angle;
    o.cache_nearest = 50;
    return o;
}

constexpr double most_photons = 1e15;  ///< far past any memory, still exact in a double
constexpr double megabyte = 1e6;

void read_counts(const Reader& in, const Params& params, PhotonOptions& o) {
    in.read("count", o.count, 1, most_photons);
    in.read("caustic_count", o.caustic_count, 0, most_photons);
    in.read("count_by_faces", o.count_by_faces);
    in.read("error", o.error, 1e-3, 1);
    if (params.has("memory")) o.memory = params.number("memory", 0, 1) * megabyte;
}

void read_lookups(const Reader& in, PhotonOptions& o) {
    in.read("k", o.k, 2, 10'000);
    in.read_above_zero("radius", o.radius);
    in.read("caustic_k", o.caustic_k, 2, 10'000);
    in.read_above_zero("caustic_radius", o.caustic_radius);
    in.read("kernel", o.kernel);
    in.read("caustic_kernel", o.caustic_kernel);
    in.read("fixed_radius", o.fixed_radius);
    in.read("count_last", o.count_last);
    in.read("normal_tolerance", o.normal_tolerance, 0, 90);
    in.read("edge", o.edge);
}

void read_cache_reach(const Params& params, PhotonOptions& o) {
    if (params.has("cache_error")) o.cache_error = params.number("cache_error", 0, 0.01, 1);
    const auto pixels = params.vector("cache_pixels", 2);
    if (!pixels) return;
    o.cache_pixels = {(*pixels)[0], (*pixels)[1]};
    if (!(o.cache_pixels[0] > 0 && o.cache_pixels[0] <= o.cache_pixels[1]))
        params.wrong("cache_pixels", "[least, most], 0 < least <= most");
}

void read_indirect(const Reader& in, PhotonOptions& o) {
    in.read("indirect", o.indirect);
    in.read("hemisphere", o.hemisphere);
    in.read("strata", o.strata);
    in.read("half_jitter", o.half_jitter);
    in.read("cache_every", o.cache_every, 1, 1000);
    in.read("cache_nearest", o.cache_nearest, 1, 1000);
    in.read("cache_edge", o.cache_edge);
    in.read("keep_map", o.keep_map);
}

}  // namespace

PhotonOptions read_photon_options(const Params& params) {
    const Reader in(params);
    Mode mode = Mode::physical;
    in.read("mode", mode);
    PhotonOptions o = mode == Mode::report ? report_options() : PhotonOptions{};
    read_counts(in, params, o);
    in.read("directions", o.directions);
    in.read("shares", o.shares);
    in.read("roulette", o.roulette);
    in.read("rr_double_count", o.rr_double_count);
    in.read("store", o.store);
    in.read("aim_caustics", o.aim_caustics);
    read_lookups(in, o);
    read_indirect(in, o);
    read_cache_reach(params, o);
    if (const auto pixel = params.vector("view_pixel", 2)) o.view_pixel = {(*pixel)[0], (*pixel)[1]};
    return o;
}

}  // namespace cardioid::photon
