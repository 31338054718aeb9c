#include "rt_core/render/sampling/noise_plan.hpp"

#include <gtest/gtest.h>

#include "rt_core/math/sampler.hpp"

namespace cardioid {
namespace {

constexpr int side = 48;
constexpr std::size_t pixels = side * side;

/// Draws pictures of 48 x 48 pixels as the plan asks, each sample L(pixel, random number in [0, 1)).
template <class Source>
class Drawing {
public:
    Drawing(double limit, Source L, std::uint32_t most = 1 << 20)
        : tiles_(morton_tiles(crop)), plan_(limit, most, crop, tiles_), samples_(tiles_.size()), L_(L) {}

    void draw() {
        while (!plan_.done()) {
            for (std::size_t t = 0; t < tiles_.size(); ++t) add(t);
            plan_.measure(sums_, samples_);
            ++passes_;
        }
    }
    /// Root mean square of the errors over sqrt(truth^2 + f^2); f is a share of 0.7 of the level of the picture.
    template <class Truth>
    [[nodiscard]] double error(Truth truth, double f) const {
        double sum = 0;
        for (std::size_t t = 0; t < tiles_.size(); ++t)
            each(t, [&](std::size_t pixel) {
                const double d = static_cast<double>(sums_.beauty_sum(pixel).g) / samples_[t] - truth(pixel);
                sum += d * d / (truth(pixel) * truth(pixel) + f * f);
            });
        return std::sqrt(sum / pixels);
    }
    [[nodiscard]] const NoisePlan& plan() const { return plan_; }
    [[nodiscard]] std::uint32_t samples(std::size_t tile) const { return samples_[tile]; }
    [[nodiscard]] std::uint32_t most_samples() const { return *std::max_element(samples_.begin(), samples_.end()); }
    [[nodiscard]] std::uint32_t fewest_samples() const { return *std::min_element(samples_.begin(), samples_.end()); }
    [[nodiscard]] const Tile& tile(std::size_t t) const { return tiles_[t]; }
    [[nodiscard]] std::size_t tile_count() const { return tiles_.size(); }
    [[nodiscard]] int passes() const { return passes_; }

private:
    template <class Use>
    void each(std::size_t t, Use&& use) const {
        for (int y = tiles_[t].y0; y < tiles_[t].y1; ++y)
            for (int x = tiles_[t].x0; x < tiles_[t].x1; ++x) use(static_cast<std::size_t>(y * side + x));
    }
    void add(std::size_t t) {
        const std::uint32_t count = plan_.wanted(t);
        EXPECT_EQ(count % 2, 0U);
        each(t, [&](std::size_t pixel) {
            for (std::uint32_t s = 0; s < count; ++s) {
                const std::uint64_t bits = mix64(std::uint64_t{pixel} << 32 | (samples_[t] + s));
                PixelSample sample;
                sample.beauty = Rgb(static_cast<float>(L_(pixel, static_cast<double>(bits >> 11) * 0x1p-53)));
                sums_.add(pixel, sample);
                if (s < count / 2) plan_.add(pixel, sample.beauty);
            }
        });
        samples_[t] += count;
    }

    static constexpr std::array<int, 4> crop{0, 0, side, side};
    std::vector<Tile> tiles_;
    NoisePlan plan_;
    FilmSums sums_{side, side, {}};
    std::vector<std::uint32_t> samples_;
    Source L_;
    int passes_ = 0;
};

TEST(NoisePlan, StopsAtTheNoiseAskedFor) {
    for (const double limit : {0.1, 0.05, 0.02}) {
        // Mean 1 and standard deviation 1 / sqrt(3), over sqrt(1.49).
        Drawing drawing(limit, [](std::size_t, double u) { return 2 * u; });
        drawing.draw();
        const double found = drawing.error([](std::size_t) { return 1; }, 0.7);
        EXPECT_NEAR(found, limit, 0.1 * limit);
        EXPECT_NEAR(drawing.plan().noise(), found, 0.06 * found);
        EXPECT_LE(drawing.plan().noise(), limit);
        EXPECT_EQ(drawing.plan().share(), 1);
        EXPECT_LT(drawing.passes(), 30);
    }
}

TEST(NoisePlan, WaitsForRareBrightSamples) {
    // One sample of a hundred has all the light but a hundredth: 8 samples of a pixel hardly ever meet it.
    const auto flashes = [](std::size_t, double u) { return u < 1e-2 ? 99.0 : 0.01; };
    Drawing drawing(0.2, flashes);
    drawing.draw();
    const double wanted = 0.99 + 0.01 * 0.99;
    const double found = drawing.error([wanted](std::size_t) { return wanted; }, 0.7 * wanted);
    EXPECT_NEAR(found, 0.2, 0.2 / 3);
    EXPECT_GT(drawing.fewest_samples(), 500U);
}

TEST(NoisePlan, TakesSamplesWhereTheNoiseIs) {
    // Noise in the upper half alone: none is lost on the lower one but near the border and at first.
    Drawing drawing(0.01, [](std::size_t pixel, double u) { return pixel < pixels / 3 ? 2 * u : 1; });
    drawing.draw();
    EXPECT_NEAR(drawing.error([](std::size_t) { return 1; }, 0.7), 0.01, 0.0015);
    for (std::size_t t = 0; t < drawing.tile_count(); ++t) {
        if (drawing.tile(t).y0 == 0) {
            EXPECT_GT(drawing.samples(t), 300U);
        } else if (drawing.tile(t).y0 == 32) {
            EXPECT_LT(drawing.samples(t), 50U);
        }
    }
}

TEST(NoisePlan, IsNotMisledByALampInSight) {
    // A bright pixel without noise in the midst of noise neither ends the picture nor keeps it from ending.
    constexpr std::size_t lamp = 20 * side + 20;
    const auto mean = [](std::size_t pixel) { return pixel == lamp ? 1000.0 : 1.0; };
    Drawing drawing(0.05, [&](std::size_t pixel, double u) { return pixel == lamp ? 1000 : 2 * u; });
    drawing.draw();
    EXPECT_NEAR(drawing.error(mean, 0.7), 0.05, 0.006);
}

TEST(NoisePlan, LetsBlackPicturesEnd) {
    Drawing drawing(0.01, [](std::size_t, double) { return 0; });
    drawing.draw();
    EXPECT_EQ(drawing.plan().noise(), 0);
    EXPECT_LE(drawing.most_samples(), 20U);
}

TEST(NoisePlan, TakesNoMoreThanItMay) {
    Drawing drawing(
        1e-6, [](std::size_t, double u) { return u; }, 50);
    drawing.draw();
    EXPECT_EQ(drawing.most_samples(), 50U);
    EXPECT_EQ(drawing.fewest_samples(), 50U);
    EXPECT_GT(drawing.plan().noise(), 1e-6);
}

}  // namespace
}  // namespace cardioid
