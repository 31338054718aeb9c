#include "tests/accuracy/measure.hpp"

#include <ctime>
#include <numbers>

#include "tests/accuracy/lit_scene.hpp"
#include "tests/accuracy/threads.hpp"

namespace cardioid::test {

namespace {

constexpr std::uint32_t fewest_runs = 8, path_runs = 32, probe_sequences = 64;
constexpr std::uint32_t first_samples = 8192, samples_a_point = 16;
/// Sums of floats that are all alike differ by so much, relative.
constexpr double rounding = 1e-6;

/// The points of one run: the place itself, or a set of it that is another in every run.
std::vector<ProbePoint> points_of(const Place& place, std::uint32_t samples, std::uint32_t seed) {
    if (place.single()) return {place.at({})};
    std::vector<ProbePoint> points(samples / samples_a_point);
    for (std::size_t i = 0; i < points.size(); ++i)
        points[i] = place.at(Vec2d(Sampler(seed, Purpose::test, 0, static_cast<std::uint32_t>(i)).next2()));
    return points;
}

/// `times` as many or a little more: powers of two and halfway between, where Sobol's points are even.
std::uint32_t more_samples(std::uint32_t samples, double times) {
    const auto wanted = static_cast<std::uint32_t>(std::min(samples * std::clamp(times, 1.4, 64.0), 2.0e9));
    const std::uint32_t power = std::bit_ceil(wanted);
    return power / 4 * 3 >= wanted ? power / 4 * 3 : power;
}

/// Standard error over the one wanted.
double lack_of(const Measured& all, const Effort& effort) {
    return all.standard_error > 0 ? all.standard_error / (effort.noise * std::abs(all.value)) : 0;
}

}  // namespace

Bench::Bench(const KnownValue& first, std::string module, std::uint32_t first_seed, Params options)
    : scene_(commit(sample_scene("accuracy/" + first.scene, first.change))),
      module_(std::move(module)),
      first_seed_(first_seed),
      options_(std::move(options)) {}

Measured Bench::measure(const KnownValue& known, const Effort& effort) {
    const Threads one(1);
    const double begin = cpu_seconds() - prepared_s_;
    const Place& place = known.place;
    Size size = first_size(place);
    const bool one_probe = place.single() && !prepares();
    const auto sized = [&] { return one_probe ? by_one_probe(place, size.each) : by_runs(place, size); };
    Measured all = sized();
    bool samples_help = true;
    while (lack_of(all, effort) > 1) {
        const Size before = size;
        if (!grow(size, effort, lack_of(all, effort), samples_help)) break;
        const Measured next = sized();
        // What a module has prepared is right to so much; more samples of it do not help then.
        if (prepares() && size.runs == before.runs && next.standard_error > 0.8 * all.standard_error)
            samples_help = false;
        all = next;
    }
    all.standard_error = std::max(all.standard_error, rounding * std::abs(all.value));
    all.cpu_s = cpu_seconds() - begin - prepared_s_;
    return all;
}

Bench::Size Bench::first_size(const Place& place) const {
    if (prepares()) return {fewest_runs, first_samples / fewest_runs};
    return place.single() ? Size{1, first_samples} : Size{path_runs, first_samples / path_runs};
}

/// False where all that is allowed has been done.
bool Bench::grow(Size& size, const Effort& effort, double lack, bool samples_help) const {
    // That samples do not help may have been chance; where there may be no more runs they are all there is.
    samples_help = samples_help || (prepares() && size.runs >= effort.most_runs);
    if (samples_help && std::uint64_t{size.runs} * size.each < effort.most_samples) {
        // Errors of even points fall faster than the root of their number, but not always.
        const auto most = static_cast<std::uint32_t>(effort.most_samples / size.runs);
        size.each = std::min(more_samples(size.each, std::pow(lack, 1.7)), most);
        return true;
    }
    if (!prepares() || size.runs >= effort.most_runs) return false;
    const double runs = size.runs * std::clamp(lack * lack * 1.2, 1.5, 4.0);
    size.runs = std::min(static_cast<std::uint32_t>(std::ceil(runs)), effort.most_runs);
    return true;
}

/// The probe's own sequences are the runs.
Measured Bench::by_one_probe(const Place& place, std::uint32_t samples) {
    Measured all{.runs = probe_sequences, .samples = samples};
    const Reading reading = readings(place, 0, samples, {place.at({})}, all).at(0);
    all.value = static_cast<double>(reading.value.g);
    all.standard_error = static_cast<double>(reading.standard_error.g);
    return all;
}

Measured Bench::by_runs(const Place& place, Size size) {
    Measured all{.runs = static_cast<int>(size.runs), .samples = std::uint64_t{size.runs} * size.each};
    std::vector<double> values(size.runs);
    for (std::uint32_t run = 0; run < size.runs; ++run) {
        values[run] = once(place, run, size.each, all);
        all.value += values[run] / size.runs;
    }
    double square = 0;
    for (const double value : values) square += (value - all.value) * (value - all.value);
    all.standard_error = std::sqrt(square / (all.runs * (all.runs - 1.0)));
    return all;
}

double Bench::once(const Place& place, std::uint32_t run, std::uint32_t samples, Measured& all) {
    const std::vector<ProbePoint> points = points_of(place, samples, first_seed_ + run);
    double sum = 0;
    for (const Reading& reading : readings(place, run, place.single() ? samples : samples_a_point, points, all))
        sum += static_cast<double>(reading.value.g);
    return sum / static_cast<double>(points.size());
}

std::vector<Reading> Bench::readings(const Place& place, std::uint32_t run, std::uint32_t samples,
                                     const std::vector<ProbePoint>& points, Measured& all) {
    const ProbeSettings settings{.what = place.what, .noise = 0, .most_samples = samples, .seed = first_seed_ + run};
    Progress silent;
    std::vector<Reading> read = probe(scene_, lighting(run), points, settings, silent);
    for (const Reading& reading : read) all.bad_samples += reading.bad_samples;
    return read;
}

/// A path tracer keeps nothing from one run to the next; another module is prepared for each by a seed of its own.
const LightingModule& Bench::lighting(std::uint32_t run) {
    const double begin = cpu_seconds();
    const std::size_t at = prepares() ? run : 0;
    while (lighting_.size() <= at)
        lighting_.push_back(prepared_lighting(
            module_, scene_, first_seed_ + static_cast<std::uint32_t>(lighting_.size()), nullptr, options_));
    prepared_s_ += cpu_seconds() - begin;
    return *lighting_[at];
}

double cpu_seconds() {
    std::timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double student_p(double t, int degrees) {
    const double n = degrees, top = std::min(std::abs(t), 1000.0);
    const double front = std::exp(std::lgamma((n + 1) / 2) - std::lgamma(n / 2)) / std::sqrt(n * std::numbers::pi);
    // Simpson's rule on x = sqrt(n) tan(a), where the density is front sqrt(n) cos^(n-1) a.
    constexpr int steps = 2000;
    const double end = std::atan(top / std::sqrt(n));
    double sum = 0;
    for (int i = 0; i <= steps; ++i) {
        const double weight = i == 0 || i == steps ? 1 : i % 2 == 1 ? 4 : 2;
        sum += weight * std::pow(std::cos(end * i / steps), n - 1);
    }
    return std::max(0.0, 1 - 2 * front * std::sqrt(n) * sum * end / (3 * steps));
}

double Measured::p_value(double expected) const {
    // Formulas and quadrature are good to so much: a small lamp is no point.
    constexpr double accuracy = 2e-5;
    const double error = std::hypot(standard_error, accuracy * expected);
    if (error <= 0) return value == expected ? 1 : 0;
    return student_p((value - expected) / error, runs - 1);
}

}  // namespace cardioid::test
