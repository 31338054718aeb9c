#include "tests/accuracy/measure.hpp"

#include <array>
#include <ctime>
#include <numbers>

#include "tests/accuracy/lit_scene.hpp"
#include "tests/accuracy/threads.hpp"

namespace cardioid::test {

namespace {

constexpr int runs = 32, probe_sequences = 64;
constexpr std::uint32_t first_samples = 8192, samples_a_point = 16;
/// Sums of floats that are all alike differ by so much, relative.
constexpr double rounding = 1e-6;

/// Of this thread.
double cpu_seconds() {
    std::timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// The points of one run: the place itself, or a set of it that is another in every run.
std::vector<ProbePoint> points_of(const Place& place, std::uint64_t samples, std::uint32_t seed) {
    if (place.single()) return {place.at({})};
    std::vector<ProbePoint> points(samples / samples_a_point);
    for (std::size_t i = 0; i < points.size(); ++i)
        points[i] = place.at(Vec2d(Sampler(seed, Purpose::test, 0, static_cast<std::uint32_t>(i)).next2()));
    return points;
}

/// `times` as many or a little more: powers of two and halfway between, where Sobol's points are even.
std::uint64_t more_samples(std::uint64_t samples, double times) {
    const auto wanted = static_cast<std::uint64_t>(static_cast<double>(samples) * std::clamp(times, 1.4, 64.0));
    const std::uint64_t power = std::bit_ceil(wanted);
    return power / 4 * 3 >= wanted ? power / 4 * 3 : power;
}

/// Measures a value again and again.
class Bench {
public:
    Bench(const KnownValue& known, const std::string& module, std::uint32_t first_seed)
        : known_(known),
          scene_(commit(sample_scene("accuracy/" + known.scene, known.change))),
          first_seed_(first_seed) {
        // A path tracer keeps nothing from one run to the next.
        const std::size_t modules = module == "path" ? 1 : runs;
        for (std::uint32_t i = 0; i < modules; ++i)
            lighting_.push_back(prepared_lighting(module, scene_, first_seed + i));
    }

    /// By about so many samples altogether.
    Measured measure(std::uint64_t samples) {
        Measured all = known_.place.single() && lighting_.size() == 1 ? by_one_probe(samples) : by_runs(samples);
        all.samples = samples;
        all.standard_error = std::max(all.standard_error, rounding * std::abs(all.value));
        return all;
    }

private:
    /// The probe's own sequences are the runs.
    Measured by_one_probe(std::uint64_t samples) {
        Measured all{.runs = probe_sequences};
        const Reading reading = readings(0, static_cast<std::uint32_t>(samples), {known_.place.at({})}, all).at(0);
        all.value = static_cast<double>(reading.value.g);
        all.standard_error = static_cast<double>(reading.standard_error.g);
        return all;
    }

    Measured by_runs(std::uint64_t samples) {
        Measured all{.runs = runs};
        std::array<double, runs> values{};
        for (std::uint32_t run = 0; run < runs; ++run) {
            values[run] = once(run, samples / runs, all);
            all.value += values[run] / runs;
        }
        double square = 0;
        for (const double value : values) square += (value - all.value) * (value - all.value);
        all.standard_error = std::sqrt(square / (runs * (runs - 1)));
        return all;
    }

    double once(std::uint32_t run, std::uint64_t samples, Measured& all) {
        const bool single = known_.place.single();
        const std::vector<ProbePoint> points = points_of(known_.place, samples, first_seed_ + run);
        double sum = 0;
        for (const Reading& reading :
             readings(run, single ? static_cast<std::uint32_t>(samples) : samples_a_point, points, all))
            sum += static_cast<double>(reading.value.g);
        return sum / static_cast<double>(points.size());
    }

    std::vector<Reading> readings(std::uint32_t run, std::uint32_t samples, const std::vector<ProbePoint>& points,
                                  Measured& all) {
        const ProbeSettings settings{
            .what = known_.place.what, .noise = 0, .most_samples = samples, .seed = first_seed_ + run};
        Progress silent;
        std::vector<Reading> read = probe(scene_, *lighting_[run % lighting_.size()], points, settings, silent);
        for (const Reading& reading : read) all.bad_samples += reading.bad_samples;
        return read;
    }

    const KnownValue& known_;
    CommittedScene scene_;
    std::uint32_t first_seed_;
    std::vector<std::unique_ptr<LightingModule>> lighting_;
};

}  // namespace

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

Measured measure(const KnownValue& known, const std::string& module, const Effort& effort) {
    const Threads one(1);
    const double begin = cpu_seconds();
    Bench bench(known, module, effort.first_seed);
    std::uint64_t samples = first_samples;
    Measured all = bench.measure(samples);
    while (all.standard_error > effort.noise * std::abs(all.value) && samples < effort.most_samples) {
        const double lack = all.standard_error / (effort.noise * std::abs(all.value));
        // Errors of even points fall faster than the root of their number, but not always.
        samples = std::min(more_samples(samples, std::pow(lack, 1.7)), effort.most_samples);
        all = bench.measure(samples);
    }
    all.cpu_s = cpu_seconds() - begin;
    return all;
}

}  // namespace cardioid::test
