#include "rt_core/render/probe.hpp"

#include <array>
#include <atomic>
#include <bit>
#include <optional>

#include "rt_core/api/parallel.hpp"
#include "rt_core/render/camera_path.hpp"
#include "rt_core/render/measure/plate.hpp"

namespace cardioid {

namespace {

/// Independent sequences; the relative error of a standard error from so many is 9 %.
constexpr std::uint32_t most_groups = 64, fewest_groups = 16;
constexpr std::uint32_t most_samples = 1U << 24;
/// Samples that are all alike are believed after this many over the noise.
constexpr double alike_samples = 10, fewest_alike = 256, most_alike = 1 << 16;
/// Points that are measured side by side, which bounds the memory.
constexpr std::size_t block_points = 1024;
/// Work is shared out in pieces of about so many samples, and interrupts are seen as often.
constexpr std::uint32_t piece_samples = 4096, between_looks = 256;

bool is_bad(Rgb c) { return !is_finite(c) || min_component(c) < 0; }

double luminance_of(const std::array<double, 3>& c) { return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]; }

/// d of any length as a unit vector.
Vec3 unit(Vec3d d) { return Vec3(normalize(d / max_component(abs(d)))); }

/// Whether direct light leaves nothing to chance: all lights are asked each time, and from each it comes to a point in
/// one direction only.
bool all_delta(const CommittedScene& scene) {
    const double far = scene.bounds().empty() ? 1 : scene.bounds().diagonal();
    if (scene.lights().size() > NextEvent::most_lights) return false;
    for (const auto& light : scene.lights()) {
        const Ray ray = light->emit({0.5F, 0.5F}, {0.5F, 0.5F}).ray;
        if (!light->sample(ray.o + ray.d * far, {0.5F, 0.5F}).delta) return false;
    }
    return true;
}

/// What is measured at one point.
struct Target {
    std::uint64_t index = 0;
    Plate plate;
    EyeRay ray;
    std::optional<Rgb> caustic;  ///< where the module looks it up and draws nothing
};

struct Group {
    std::array<double, 3> sum{};
    std::uint32_t bad = 0;
};

/// A point under way: `each` samples in each of its groups.
struct Spot {
    Target target;
    std::uint32_t each = 0, next = 0;
    bool done = false;
    double wanted = 1;  ///< samples over those that are there, for the noise
    std::array<Group, most_groups> groups;
};

class Job {
public:
    Job(const CommittedScene& scene, const LightingModule& module, const ProbeSettings& settings, Progress& progress)
        : scene_(scene),
          module_(module),
          settings_(settings),
          progress_(progress),
          finder_(scene),
          delta_lights_(all_delta(scene)),
          most_(settings.most_samples > 0 ? std::max(settings.most_samples, fewest_groups) : most_samples),
          group_count_(std::min(most_groups, most_)) {}

    std::vector<Reading> run(std::span<const ProbePoint> points) {
        std::vector<Reading> readings(points.size());
        for (std::size_t begin = 0; begin < points.size() && !progress_.interrupted(); begin += block_points) {
            const std::size_t count = std::min(block_points, points.size() - begin);
            measure(points.subspan(begin, count), begin, points.size(), &readings[begin]);
        }
        return readings;
    }

private:
    void measure(std::span<const ProbePoint> points, std::size_t before, std::size_t all, Reading* readings);
    void begin(Spot& spot, const ProbePoint& point, std::uint64_t index, Reading& reading) const;
    void aim(Target& target, const ProbePoint& point) const noexcept;
    /// One sample; `drawn` becomes true where it hangs on random numbers.
    [[nodiscard]] Rgb sample(const Target& target, std::uint32_t group, std::uint32_t number,
                             bool& drawn) const noexcept;
    bool add_samples(Spot& spot, std::uint32_t group) const noexcept;
    void conclude(Spot& spot, Reading& reading) const noexcept;
    void run_round(std::vector<Spot>& spots, std::span<const std::size_t> active, double share, double next_share);

    const CommittedScene& scene_;
    const LightingModule& module_;
    const ProbeSettings& settings_;
    Progress& progress_;
    PlateFinder finder_;
    bool delta_lights_;
    std::uint32_t most_, group_count_;
};

void Job::aim(Target& target, const ProbePoint& point) const noexcept {
    const Vec3 d = unit(point.d);
    target.plate = finder_.place(point.p, d);
    const SurfacePoint& at = target.plate.point;
    if (settings_.what == Quantity::irradiance) {
        Sampler sampler(settings_.seed, Purpose::probe, target.index * most_groups, 0);
        const Sampler fresh = sampler;
        const Rgb caustic = module_.caustic(scene_, at, PlateBsdf(target.plate.horizon), target.plate.normal, sampler);
        if (sampler == fresh) target.caustic = caustic;
        return;
    }
    target.ray.ray = at.ray(d);
    target.ray.medium = dot(at.ng, d) > 0 ? at.front : at.back;
}

Rgb Job::sample(const Target& target, std::uint32_t group, std::uint32_t number, bool& drawn) const noexcept {
    Sampler sampler(settings_.seed, Purpose::probe, target.index * most_groups + group, number);
    if (settings_.what == Quantity::radiance) {
        const Sampler fresh = sampler;
        const Rgb L = light_along(scene_, module_, target.ray, sampler).sum();
        drawn = !(sampler == fresh);
        return L;
    }
    const SurfacePoint& point = target.plate.point;
    const Vec3 wo = target.plate.normal;
    const PlateBsdf white(target.plate.horizon);
    const Rgb direct = scene_.direct(point, white, wo, sampler, &module_);
    const Sampler then = sampler;
    const Rgb caustic = target.caustic ? *target.caustic : module_.caustic(scene_, point, white, wo, sampler);
    const Rgb indirect = module_.indirect(scene_, point, white, wo, sampler);
    drawn = !delta_lights_ || !(sampler == then);
    return (direct + caustic + indirect) * pi;
}

void Job::begin(Spot& spot, const ProbePoint& point, std::uint64_t index, Reading& reading) const {
    spot.target.index = index;
    aim(spot.target, point);
    spot.done = reading.buried = spot.target.plate.buried;
    if (spot.done) return;
    bool drawn = true;
    const Rgb value = sample(spot.target, 0, 0, drawn);
    if (!drawn) {
        reading.samples = 1;
        reading.bad_samples = is_bad(value);
        if (!is_bad(value)) reading.value = value;
        spot.done = true;
        return;
    }
    spot.next = 1;
    for (std::uint32_t group = 0; group < group_count_; ++group) add_samples(spot, group);
    conclude(spot, reading);
}

/// False where it has been interrupted.
bool Job::add_samples(Spot& spot, std::uint32_t group) const noexcept {
    Group& to = spot.groups[group];
    bool drawn = true;
    for (std::uint32_t i = spot.each; i < spot.next; ++i) {
        if (i % between_looks == between_looks - 1 && progress_.interrupted()) return false;
        const Rgb value = sample(spot.target, group, i, drawn);
        if (is_bad(value))
            ++to.bad;
        else
            to.sum[0] += value.r, to.sum[1] += value.g, to.sum[2] += value.b;
    }
    return true;
}

/// Mean and standard error of the groups' means, and whether they will do.
void Job::conclude(Spot& spot, Reading& reading) const noexcept {
    spot.each = spot.next;
    const double n = group_count_;
    std::array<double, 3> mean{}, square{};
    double mean_luminance = 0, square_luminance = 0;
    reading.bad_samples = 0;
    for (std::uint32_t g = 0; g < group_count_; ++g) {
        for (std::size_t c = 0; c < 3; ++c) mean[c] += spot.groups[g].sum[c] / (n * spot.each);
        reading.bad_samples += spot.groups[g].bad;
    }
    mean_luminance = luminance_of(mean);
    for (std::uint32_t g = 0; g < group_count_; ++g) {
        std::array<double, 3> off{};
        for (std::size_t c = 0; c < 3; ++c) {
            off[c] = spot.groups[g].sum[c] / spot.each - mean[c];
            square[c] += off[c] * off[c];
        }
        square_luminance += luminance_of(off) * luminance_of(off);
    }
    const auto error = [n](double sum) { return std::sqrt(sum / (n * (n - 1))); };
    const auto rgb = [](double r, double g, double b) {
        return Rgb(static_cast<float>(r), static_cast<float>(g), static_cast<float>(b));
    };
    reading.value = rgb(mean[0], mean[1], mean[2]);
    reading.standard_error = rgb(error(square[0]), error(square[1]), error(square[2]));
    reading.samples = group_count_ * spot.each;

    const double noise = settings_.noise, relative = error(square_luminance) / mean_luminance;
    // Rounding makes sums of equal samples differ in their last digits.
    const bool alike = !(relative > 1e-12);
    const double enough = std::clamp(alike_samples / noise, fewest_alike, most_alike);
    spot.wanted = noise <= 0 ? most_ / static_cast<double>(reading.samples)
                  : alike    ? enough / reading.samples
                             : relative * relative / (noise * noise);
    reading.reached = noise <= 0 || alike || spot.wanted <= 1;
    spot.done = spot.each >= most_ / group_count_ || (noise > 0 && spot.wanted <= 1);
    // Sizes 1, 2, 3, 4, 6, 8, 12 ...: powers of two and halfway between, where Sobol's points are even.
    const std::uint32_t half = std::has_single_bit(spot.each) ? spot.each / 2 : spot.each / 3;
    const bool little = half > 0 && spot.wanted * spot.each <= spot.each + half;
    spot.next = std::min(little ? spot.each + half : std::bit_ceil(spot.each + 1), most_ / group_count_);
}

void Job::run_round(std::vector<Spot>& spots, std::span<const std::size_t> active, double share, double next_share) {
    struct Piece {
        std::size_t spot;
        std::uint32_t first, last;  ///< groups
    };
    std::vector<Piece> pieces;
    for (const std::size_t i : active) {
        const std::uint32_t a_group = spots[i].next - spots[i].each;
        const std::uint32_t step = std::clamp(piece_samples / a_group, 1U, group_count_);
        for (std::uint32_t g = 0; g < group_count_; g += step)
            pieces.push_back({i, g, std::min(g + step, group_count_)});
    }
    std::atomic<std::size_t> finished{0};
    parallel_for(static_cast<std::int64_t>(pieces.size()), [&](std::int64_t i) {
        const Piece& piece = pieces[static_cast<std::size_t>(i)];
        for (std::uint32_t g = piece.first; g < piece.last; ++g)
            if (!add_samples(spots[piece.spot], g)) return;
        const double part = static_cast<double>(++finished) / static_cast<double>(pieces.size());
        progress_.update(share + (next_share - share) * part);
    });
}

void Job::measure(std::span<const ProbePoint> points, std::size_t before, std::size_t all, Reading* readings) {
    std::vector<Spot> spots(points.size());
    parallel_for(static_cast<std::int64_t>(points.size()), [&](std::int64_t i) {
        if (progress_.interrupted()) return;
        const auto at = static_cast<std::size_t>(i);
        begin(spots[at], points[at], settings_.first + before + at, readings[at]);
    });
    while (!progress_.interrupted()) {
        std::vector<std::size_t> active;
        double share = static_cast<double>(before), next_share = share;
        for (std::size_t i = 0; i < spots.size(); ++i) {
            const Spot& spot = spots[i];
            if (!spot.done) active.push_back(i);
            share += spot.done ? 1 : std::min(0.99, 1 / spot.wanted);
            next_share += spot.done ? 1 : std::min(0.99, spot.next / (spot.wanted * spot.each));
        }
        const auto total = static_cast<double>(all);
        progress_.update(share / total);
        if (active.empty()) return;
        run_round(spots, active, share / total, next_share / total);
        // Of a round that was cut short nothing is used.
        if (progress_.interrupted()) return;
        for (const std::size_t i : active) conclude(spots[i], readings[i]);
    }
}

}  // namespace

std::vector<Reading> probe(const CommittedScene& scene, const LightingModule& lighting,
                           std::span<const ProbePoint> points, const ProbeSettings& settings, Progress& progress) {
    return Job(scene, lighting, settings, progress).run(points);
}

}  // namespace cardioid
