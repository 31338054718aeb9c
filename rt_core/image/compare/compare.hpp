#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "rt_core/image/compare/picture.hpp"

namespace cardioid {

/// A named part of a picture: x0 <= x < x1, y0 <= y < y1, pixels from the top left.
struct PictureRegion {
    std::string name;
    int x0, y0, x1, y1;
};

struct CompareSettings {
    std::vector<PictureRegion> regions;  ///< besides the whole
    double tolerance = 1e-3;             ///< relative difference from which on a pixel counts as `beyond`
    double exposure = 0;                 ///< EV, for FLIP: both are shown at 2^exposure
    bool skip_edges = false;             ///< leave out pixels next to a change of solid, normal or depth
};

/// What a part of two pictures differs by; a is looked at, b is the reference. Channels count alike.
struct RegionFigures {
    std::string name;
    std::size_t pixels = 0;  ///< that count
    Rgb mean_a, mean_b;
    double bias = 0;          ///< (mean a - mean b) / mean b over the channels' mean
    double rmse = 0;          ///< root of the mean squared difference
    double relative_mse = 0;  ///< mean of (a - b)^2 / (b^2 + (mean b / 10)^2)
    double p999 = 0;          ///< difference that 99.9 % of the pixels do not exceed, of their worst channel
    double max = 0;           ///< largest difference of a channel
    int max_x = 0, max_y = 0;
    double beyond = 0;        ///< share of pixels whose worst channel is off by more than the tolerance times their
                              ///< brightest channel in b (or a hundredth of mean b)
    double flip = 0;          ///< mean of LDR-FLIP, 0 to 1
    std::optional<double> z;  ///< difference of the means in standard errors, where variances are known
};

struct Comparison {
    RegionFigures whole;
    std::vector<RegionFigures> regions;
    std::vector<float> flip;  ///< of every pixel
    std::size_t skipped = 0;  ///< pixels left out at edges
    std::size_t bad = 0;      ///< pixels where either is not finite; they count as 0 elsewhere
    std::array<int, 2> first_bad{-1, -1};
};

/// What keeps two pictures from being compared at all: other size, other channels; "" where nothing does. Alpha that is
/// 1 everywhere counts as none.
std::string mismatch(const Picture& a, const Picture& b);

/// Variances come from layers "variance" (of the pixel's mean, one or three channels); where only one picture has one
/// the other is taken to be exact. Edges come from layers region, normal and depth of either. Throws Error(usage) where
/// skip_edges is asked for and neither has such a layer, or a region is not within the picture. mismatch(a, b) is "".
Comparison compare(const Picture& a, const Picture& b, const CompareSettings& settings);

}  // namespace cardioid
