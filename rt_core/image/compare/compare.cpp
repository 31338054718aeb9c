#include "rt_core/image/compare/compare.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "rt_core/api/error.hpp"
#include "rt_core/image/compare/edges.hpp"
#include "rt_core/image/compare/flip.hpp"

namespace cardioid {

namespace {

/// Of the mean of the reference: what is added to a pixel where it is the divisor, so that black is no infinity.
constexpr double relative_floor = 0.1, tolerance_floor = 0.01;

bool opaque(const Picture& p) {
    return std::all_of(p.alpha.begin(), p.alpha.end(), [](float a) { return a == 1; });
}

/// Two pictures with what is needed of them everywhere: bad pixels taken out, edges known.
class Comparer {
public:
    Comparer(const Picture& a, const Picture& b, const CompareSettings& settings)
        : settings_(settings),
          width_(a.width),
          height_(a.height),
          a_(a.pixels),
          b_(b.pixels),
          counts_(a.pixels.size(), true) {
        take_out_bad();
        if (settings.skip_edges) skip_edges(a, b);
        if (a.alpha.size() == b.alpha.size()) alpha_a_ = a.alpha, alpha_b_ = b.alpha;
        add_variance(a), add_variance(b);
        out_.flip = cardioid::flip(shown(b_), shown(a_), width_);
    }

    Comparison run() {
        out_.whole = figures({"all", 0, 0, width_, height_});
        for (const PictureRegion& region : settings_.regions) {
            if (region.x0 < 0 || region.y0 < 0 || region.x1 > width_ || region.y1 > height_ || region.x0 >= region.x1 ||
                region.y0 >= region.y1)
                throw Error(
                    ErrorCode::usage,
                    fmt::format("region \"{}\": found {},{},{},{}, wanted 0 <= x0 < x1 <= {} and 0 <= y0 < y1 <= {}",
                                region.name, region.x0, region.y0, region.x1, region.y1, width_, height_));
            out_.regions.push_back(figures(region));
        }
        return std::move(out_);
    }

private:
    void take_out_bad() {
        for (std::size_t i = 0; i < a_.size(); ++i) {
            if (is_finite(a_[i]) && is_finite(b_[i])) continue;
            if (out_.bad++ == 0) {
                const auto columns = static_cast<std::size_t>(width_);
                out_.first_bad = {static_cast<int>(i % columns), static_cast<int>(i / columns)};
            }
            a_[i] = b_[i] = {};
            counts_[i] = false;
        }
    }

    void skip_edges(const Picture& a, const Picture& b) {
        const std::vector<bool> in_a = find_edges(a), in_b = find_edges(b);
        if (in_a.empty() && in_b.empty())
            throw Error(ErrorCode::usage,
                        "--skip-edges: neither picture has a layer normal, depth or region; render one with --aov");
        for (std::size_t i = 0; i < counts_.size(); ++i)
            if (counts_[i] && ((!in_a.empty() && in_a[i]) || (!in_b.empty() && in_b[i]))) {
                counts_[i] = false;
                ++out_.skipped;
            }
    }

    void add_variance(const Picture& p) {
        const Layer* layer = p.layer("variance");
        if (!layer || (layer->channels != 1 && layer->channels != 3)) return;
        variance_.resize(a_.size());
        const auto channels = static_cast<std::size_t>(layer->channels);
        for (std::size_t i = 0; i < variance_.size(); ++i) {
            // Of the channels' mean: a ninth of their sum, or of one that stands for all three a whole.
            double sum = 0;
            for (std::size_t c = 0; c < channels; ++c) sum += double{layer->pixels[i * channels + c]};
            variance_[i] += channels == 3 ? sum / 9 : sum;
        }
    }

    [[nodiscard]] std::vector<Rgb> shown(const std::vector<Rgb>& pixels) const {
        std::vector<Rgb> out = pixels;
        const auto gain = static_cast<float>(std::exp2(settings_.exposure));
        for (Rgb& p : out) p *= gain;
        return out;
    }

    struct Sums {
        std::array<double, 3> a{}, b{};
        double squared = 0, flip = 0, variance = 0;
    };

    template <class Use>
    void for_pixels(const PictureRegion& region, Use&& use) const {
        for (int y = region.y0; y < region.y1; ++y)
            for (int x = region.x0; x < region.x1; ++x) {
                const std::size_t i =
                    static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
                if (counts_[i]) use(i, x, y);
            }
    }

    /// The difference of the worst channel, alpha among them.
    [[nodiscard]] double worst(std::size_t i) const {
        const Rgb d = a_[i] - b_[i];
        const double colour = double{std::max(std::abs(d.r), std::max(std::abs(d.g), std::abs(d.b)))};
        return alpha_a_.empty() ? colour : std::max(colour, std::abs(double{alpha_a_[i]} - double{alpha_b_[i]}));
    }

    [[nodiscard]] RegionFigures figures(const PictureRegion& region) const {
        RegionFigures out;
        out.name = region.name;
        Sums sums;
        std::vector<double> differences;
        for_pixels(region, [&](std::size_t i, int x, int y) {
            ++out.pixels;
            const std::array<float, 3> a{a_[i].r, a_[i].g, a_[i].b}, b{b_[i].r, b_[i].g, b_[i].b};
            for (std::size_t c = 0; c < 3; ++c) {
                const double d = double{a[c]} - double{b[c]};
                sums.a[c] += double{a[c]}, sums.b[c] += double{b[c]}, sums.squared += d * d;
            }
            sums.flip += double{out_.flip[i]};
            if (!variance_.empty()) sums.variance += variance_[i];
            const double d = worst(i);
            differences.push_back(d);
            if (d > out.max) out.max = d, out.max_x = x, out.max_y = y;
        });
        if (out.pixels == 0) return out;
        const auto n = static_cast<double>(out.pixels);
        const auto rgb = [&](const std::array<double, 3>& s) {
            return Rgb{static_cast<float>(s[0] / n), static_cast<float>(s[1] / n), static_cast<float>(s[2] / n)};
        };
        const double total_a = (sums.a[0] + sums.a[1] + sums.a[2]) / (3 * n);
        const double total_b = (sums.b[0] + sums.b[1] + sums.b[2]) / (3 * n);
        out.mean_a = rgb(sums.a), out.mean_b = rgb(sums.b);
        out.bias = total_a == total_b ? 0 : total_b != 0 ? (total_a - total_b) / total_b : HUGE_VAL;
        out.rmse = std::sqrt(sums.squared / (3 * n));
        out.flip = sums.flip / n;
        if (sums.variance > 0) out.z = (total_a - total_b) * n / std::sqrt(sums.variance);
        relative(region, total_b, out);
        const auto at = std::min(differences.size() - 1, static_cast<std::size_t>(0.999 * n));
        std::nth_element(differences.begin(), differences.begin() + static_cast<std::ptrdiff_t>(at), differences.end());
        out.p999 = differences[at];
        return out;
    }

    void relative(const PictureRegion& region, double mean_b, RegionFigures& out) const {
        const double floor = relative_floor * mean_b, least = tolerance_floor * std::abs(mean_b);
        double sum = 0;
        std::size_t beyond = 0;
        for_pixels(region, [&](std::size_t i, int, int) {
            const Rgb d = a_[i] - b_[i];
            const auto term = [&](float difference, float reference) {
                if (difference == 0) return 0.0;
                const double r = double{reference};
                return double{difference} * double{difference} / (r * r + floor * floor);
            };
            sum += term(d.r, b_[i].r) + term(d.g, b_[i].g) + term(d.b, b_[i].b);
            const double brightest = std::max(double{max_component(b_[i])}, least);
            if (worst(i) > settings_.tolerance * brightest) ++beyond;
        });
        const auto n = static_cast<double>(out.pixels);
        out.relative_mse = sum / (3 * n);
        out.beyond = static_cast<double>(beyond) / n;
    }

    const CompareSettings& settings_;
    int width_, height_;
    std::vector<Rgb> a_, b_;
    std::vector<bool> counts_;
    std::vector<float> alpha_a_, alpha_b_;
    std::vector<double> variance_;  ///< of the difference of the channels' mean; empty where unknown
    Comparison out_;
};

}  // namespace

std::string mismatch(const Picture& a, const Picture& b) {
    if (a.width != b.width || a.height != b.height)
        return fmt::format("{} is {}x{} pixels, {} is {}x{}", a.path, a.width, a.height, b.path, b.width, b.height);
    const auto colour = [](const Picture& p) { return p.channels >= 3; };
    const auto alpha = [](const Picture& p) { return !p.alpha.empty() && !opaque(p); };
    if (colour(a) != colour(b))
        return fmt::format("{} is {}, {} is {}", a.path, colour(a) ? "coloured" : "grey", b.path,
                           colour(b) ? "coloured" : "grey");
    if (a.alpha.empty() != b.alpha.empty() && (alpha(a) || alpha(b)))
        return fmt::format("{} has alpha, {} has none", (alpha(a) ? a : b).path, (alpha(a) ? b : a).path);
    return "";
}

Comparison compare(const Picture& a, const Picture& b, const CompareSettings& settings) {
    return Comparer(a, b, settings).run();
}

}  // namespace cardioid
