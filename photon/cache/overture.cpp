#include "photon/cache/overture.hpp"

#include <atomic>

#include "photon/gather/side.hpp"
#include "rt_core/api/parallel.hpp"

namespace cardioid::photon {

namespace {

constexpr int coarsest = 64;
/// Pixels that one thread looks through at a time.
constexpr std::size_t chunk_size = 256;

/// Pixels that are looked through in one step: x0 + i spacing, y0 + j spacing.
struct Step {
    int x0, y0, spacing;
    std::uint32_t round;  ///< 0: through the middle of pixels
};

/// Of one spacing the pixels in the middle come first, so that what they lack is there when their neighbours ask.
std::vector<Step> all_steps(int rounds) {
    std::vector<Step> steps{{0, 0, coarsest, 0}};
    for (int half = coarsest / 2; half >= 1; half /= 2)
        for (const auto& [x, y] : {std::pair{half, half}, {half, 0}, {0, half}}) steps.push_back({x, y, 2 * half, 0});
    for (int round = 1; round <= rounds; ++round)
        for (const auto& [x, y] : {std::pair{0, 0}, {1, 1}, {1, 0}, {0, 1}})
            steps.push_back({x, y, 2, static_cast<std::uint32_t>(round)});
    return steps;
}

/// A place that a cache lacks a point at.
struct Gap {
    SurfacePoint point;
    Vec3 n;
    std::size_t fill;
};

class Overture {
public:
    Overture(const Eye& eye, std::span<const CacheFill> fills, const OvertureRule& rule, Progress& progress)
        : eye_(eye), fills_(fills), rule_(rule), progress_(progress) {}

    void play() {
        const std::vector<Step> steps = all_steps(rule_.rounds);
        for (std::size_t i = 0; i < steps.size() && !progress_.interrupted(); ++i) {
            begin_ = static_cast<double>(i) / static_cast<double>(steps.size());
            share_ = 1 / static_cast<double>(steps.size());
            fill(gaps(steps[i]));
        }
    }

private:
    struct Pixel {
        int x, y;
    };

    [[nodiscard]] std::vector<Pixel> pixels(const Step& step) const {
        const Eye::Crop crop = eye_.crop();
        std::vector<Pixel> list;
        for (int y = crop.y0 + step.y0; y < crop.y1; y += step.spacing)
            for (int x = crop.x0 + step.x0; x < crop.x1; x += step.spacing) list.push_back({x, y});
        return list;
    }

    [[nodiscard]] std::vector<Gap> gaps(const Step& step) const {
        const std::vector<Pixel> list = pixels(step);
        std::vector<std::vector<Gap>> chunks((list.size() + chunk_size - 1) / chunk_size);
        parallel_for(static_cast<std::int64_t>(chunks.size()), [&](std::int64_t c) {
            const auto chunk = static_cast<std::size_t>(c);
            const std::size_t end = std::min((chunk + 1) * chunk_size, list.size());
            for (std::size_t i = chunk * chunk_size; i < end && !progress_.interrupted(); ++i)
                look(list[i], step.round, chunks[chunk]);
        });
        std::vector<Gap> all;
        for (const auto& chunk : chunks) all.insert(all.end(), chunk.begin(), chunk.end());
        return all;
    }

    void look(Pixel pixel, std::uint32_t round, std::vector<Gap>& gaps) const {
        const auto number = static_cast<std::uint64_t>(pixel.y) * static_cast<std::uint64_t>(eye_.width()) +
                            static_cast<std::uint64_t>(pixel.x);
        Sampler sampler(rule_.seed, Purpose::statistics, number, round);
        const Vec2 u = round == 0 ? Vec2{0.5F, 0.5F} : sampler.next2();
        const Vec2d film{pixel.x + double{u.x}, pixel.y + double{u.y}};
        eye_.look(film, sampler, [&](const Eye::Sight& sight) {
            if (!any(sight.bsdf.lobes() & Lobe::diffuse)) return;
            const Vec3 n = shading_normal(sight.point, sight.wo);
            for (std::size_t i = 0; i < fills_.size(); ++i)
                if (fills_[i].cache.lacks(sight.point.p, n)) gaps.push_back({sight.point, n, i});
        });
    }

    void fill(const std::vector<Gap>& gaps) {
        std::vector<std::vector<CacheRecord>> records(fills_.size());
        std::vector<std::size_t> place(gaps.size());
        for (std::size_t g = 0; g < gaps.size(); ++g) {
            place[g] = records[gaps[g].fill].size();
            records[gaps[g].fill].emplace_back();
        }
        std::atomic<std::size_t> done{0};
        parallel_for(static_cast<std::int64_t>(gaps.size()), [&](std::int64_t i) {
            if (progress_.interrupted()) return;
            const auto g = static_cast<std::size_t>(i);
            const Gap& gap = gaps[g];
            const CacheFill& fill = fills_[gap.fill];
            CacheRecord& record = records[gap.fill][place[g]];
            record = fill.make(gap.point, gap.n, fill.cache.records().size() + place[g]);
            const auto footprint = static_cast<float>(gap.point.footprint);
            record.least = fill.cache.rules().least_pixels * footprint;
            record.most = fill.cache.rules().most_pixels * footprint;
            progress_.update(begin_ + share_ * static_cast<double>(++done) / static_cast<double>(gaps.size()));
        });
        for (std::size_t i = 0; i < fills_.size() && !progress_.interrupted(); ++i)
            if (!records[i].empty()) fills_[i].cache.add(std::move(records[i]));
    }

    const Eye& eye_;
    std::span<const CacheFill> fills_;
    const OvertureRule& rule_;
    Progress& progress_;
    double begin_ = 0, share_ = 0;
};

}  // namespace

void play_overture(const Eye& eye, std::span<const CacheFill> fills, const OvertureRule& rule, Progress& progress) {
    Overture(eye, fills, rule, progress).play();
}

}  // namespace cardioid::photon
