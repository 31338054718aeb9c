#include "rt_core/render/renderer.hpp"

#include <atomic>
#include <ctime>
#include <fmt/format.h>
#include <mutex>

#include "rt_core/api/parallel.hpp"
#include "rt_core/render/film_sums.hpp"
#include "rt_core/render/picture_eye.hpp"
#include "rt_core/render/ray_counts.hpp"
#include "rt_core/render/sampling/noise_plan.hpp"
#include "rt_core/render/sampling/pixel_filter.hpp"
#include "rt_core/render/sampling/pixel_stream.hpp"
#include "rt_core/render/stop_rule.hpp"
#include "rt_core/render/views.hpp"

namespace cardioid {

namespace {

double thread_cpu_seconds() {
    std::timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_nsec) * 1e-9;
}

bool is_bad(Rgb c) { return !is_finite(c) || min_component(c) < 0; }

class Job {
public:
    Job(const CommittedScene& scene, const LightingModule& module, const RenderSettings& settings, Progress& progress)
        : scene_(scene),
          module_(module),
          settings_(settings),
          progress_(progress),
          eye_(scene, settings),
          crop_{eye_.crop().x0, eye_.crop().y0, eye_.crop().x1, eye_.crop().y1},
          sums_(crop_[2] - crop_[0], crop_[3] - crop_[1], settings.layers),
          tiles_(morton_tiles(crop_)),
          samples_(tiles_.size()),
          plan_(settings) {
        if (!settings.view.empty()) view_.emplace(settings.view, scene, module);
        if (settings.noise > 0) noise_.emplace(settings.noise, plan_.most_samples(), crop_, tiles_);
        if (settings.samples <= 0 && !(settings.time_s > 0) && !(settings.noise > 0))
            throw Error(ErrorCode::usage, fmt::format("{} samples a pixel: at least 1 is wanted", settings.samples));
    }

    RenderResult run() {
        progress_.begin("render");
        while (!stopped() && pass()) {
        }
        if (noise_) statistics_.noise = noise_->noise();
        statistics_.interrupted = progress_.interrupted();
        statistics_.seconds = plan_.seconds();
        statistics_.samples = static_cast<int>(samples_done_ / pixel_count());
        name_bad_pixel();
        return {std::move(sums_).finish(pixel_samples()), statistics_};
    }

private:
    [[nodiscard]] std::size_t pixel_count() const {
        return static_cast<std::size_t>(crop_[2] - crop_[0]) * static_cast<std::size_t>(crop_[3] - crop_[1]);
    }
    [[nodiscard]] std::size_t film_index(int x, int y) const {
        return static_cast<std::size_t>(y - crop_[1]) * static_cast<std::size_t>(crop_[2] - crop_[0]) +
               static_cast<std::size_t>(x - crop_[0]);
    }
    /// Of the pixel in the whole picture, whatever the crop.
    [[nodiscard]] std::uint64_t number_of(int x, int y) const {
        return static_cast<std::uint64_t>(y) * static_cast<std::uint64_t>(settings_.width) +
               static_cast<std::uint64_t>(x);
    }
    /// The user or the clock wants an end; the clock only once every pixel has had a sample.
    [[nodiscard]] bool stopped() const { return progress_.interrupted() || (covered_ && plan_.time_is_up()); }

    bool pass();
    void render_tile(std::size_t index, std::uint32_t count);
    [[nodiscard]] EyeRay camera_ray(int x, int y, Sampler& sampler) const noexcept;
    void sample(int x, int y, Sampler& sampler, PixelSample& out) const noexcept;
    [[nodiscard]] std::vector<std::size_t> pixels_of(const Tile& tile) const;
    [[nodiscard]] std::vector<std::uint32_t> pixel_samples() const;
    void name_bad_pixel();

    const CommittedScene& scene_;
    const LightingModule& module_;
    const RenderSettings& settings_;
    Progress& progress_;
    PictureEye eye_;
    std::array<int, 4> crop_;
    FilmSums sums_;
    std::vector<Tile> tiles_;
    std::vector<std::uint32_t> samples_;  ///< a pixel, of each tile
    bool covered_ = false;                ///< every pixel has a sample
    PassPlan plan_;
    std::optional<View> view_;
    std::optional<NoisePlan> noise_;

    std::atomic<std::uint64_t> samples_done_{0};
    std::mutex mutex_;  ///< guards the two below
    RenderStatistics statistics_;
    std::size_t first_bad_ = SIZE_MAX;
};

EyeRay Job::camera_ray(int x, int y, Sampler& sampler) const noexcept {
    Vec2d film{x + 0.5, y + 0.5};
    if (settings_.samples != 1) {
        const Vec2 u = sampler.next2();
        film = film + (settings_.filter == Filter::box ? sample_box_filter(u) : sample_gaussian_filter(u));
    }
    return eye_.ray(film, eye_.has_lens() ? sampler.next2() : Vec2{});
}

/// Into what the sample before has left: clearing it takes a twentieth of a quick picture's time.
void Job::sample(int x, int y, Sampler& sampler, PixelSample& out) const noexcept {
    const EyeRay camera = camera_ray(x, y, sampler);
    ++ray_counts.camera;
    if (sums_.wants_first_hit()) out.first = first_hit(scene_, camera);
    if (view_) {
        out.beauty = view_->colour(camera);
        return;
    }
    out.parts = light_along(scene_, module_, camera, sampler);
    out.beauty = out.parts.sum();
}

/// More samples in all tiles, or in those where the noise asks for them; false where none are left to take.
bool Job::pass() {
    // Without a noise to reach all tiles have the same number of samples.
    const std::uint32_t each = plan_.next(samples_[0]);
    if (noise_ ? noise_->done() : each == 0) return false;
    parallel_for(static_cast<std::int64_t>(tiles_.size()), [&](std::int64_t i) {
        const auto tile = static_cast<std::size_t>(i);
        const std::uint32_t count = noise_ ? noise_->wanted(tile) : each;
        if (count > 0 && !stopped()) render_tile(tile, count);
    });
    covered_ = true;
    // A tile may have no samples yet where the user has ended it.
    if (noise_ && !progress_.interrupted()) noise_->measure(sums_, samples_);
    return true;
}

void Job::render_tile(std::size_t index, std::uint32_t count) {
    const std::uint32_t first = samples_[index];
    const RayCounts before = ray_counts;
    const double cpu = thread_cpu_seconds();
    const Tile& tile = tiles_[index];
    std::uint64_t bad = 0;
    std::size_t first_bad = SIZE_MAX;
    PixelStream stream(settings_.seed, noise_.has_value());
    PixelSample found;
    for (int y = tile.y0; y < tile.y1; ++y)
        for (int x = tile.x0; x < tile.x1; ++x) {
            const std::size_t pixel = film_index(x, y);
            stream.begin(number_of(x, y), first, count);
            for (std::uint32_t s = 0; s < count; ++s) {
                Sampler sampler = stream.next();
                sample(x, y, sampler, found);
                if (is_bad(found.beauty)) {
                    ++bad;
                    first_bad = std::min(first_bad, pixel);
                    found.beauty = {};
                    found.parts = {};
                }
                sums_.add(pixel, found);
                if (noise_ && s < count / 2) noise_->add(pixel, found.beauty);
            }
        }
    samples_[index] = first + count;

    const auto pixels = static_cast<std::uint64_t>(tile.x1 - tile.x0) * static_cast<std::uint64_t>(tile.y1 - tile.y0);
    const std::uint64_t done = samples_done_ += pixels * count;
    progress_.update(
        plan_.share(static_cast<double>(done) / static_cast<double>(pixel_count()), noise_ ? noise_->share() : 0));
    const std::lock_guard lock(mutex_);
    statistics_.camera_rays += ray_counts.camera - before.camera;
    statistics_.shadow_rays += ray_counts.shadow - before.shadow;
    statistics_.specular_rays += ray_counts.specular - before.specular;
    statistics_.bounce_rays += ray_counts.bounce - before.bounce;
    statistics_.bad_samples += bad;
    statistics_.cpu_seconds += thread_cpu_seconds() - cpu;
    first_bad_ = std::min(first_bad_, first_bad);
}

std::vector<std::size_t> Job::pixels_of(const Tile& tile) const {
    std::vector<std::size_t> pixels;
    for (int y = tile.y0; y < tile.y1; ++y)
        for (int x = tile.x0; x < tile.x1; ++x) pixels.push_back(film_index(x, y));
    return pixels;
}

std::vector<std::uint32_t> Job::pixel_samples() const {
    std::vector<std::uint32_t> samples(pixel_count());
    for (std::size_t i = 0; i < tiles_.size(); ++i)
        for (const std::size_t pixel : pixels_of(tiles_[i])) samples[pixel] = samples_[i];
    return samples;
}

void Job::name_bad_pixel() {
    if (first_bad_ == SIZE_MAX) return;
    const auto width = static_cast<std::size_t>(crop_[2] - crop_[0]);
    statistics_.first_bad_pixel = {crop_[0] + static_cast<int>(first_bad_ % width),
                                   crop_[1] + static_cast<int>(first_bad_ / width)};
}

}  // namespace

RenderResult render(const CommittedScene& scene, const LightingModule& lighting, const RenderSettings& settings,
                    Progress& progress) {
    return Job(scene, lighting, settings, progress).run();
}

}  // namespace cardioid
