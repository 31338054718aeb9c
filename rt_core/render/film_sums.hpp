#pragma once
#include <array>
#include <string>
#include <vector>

#include "rt_core/render/camera_path.hpp"
#include "rt_core/render/renderer.hpp"

namespace cardioid {

/// What one sample of a pixel found.
struct PixelSample {
    Rgb beauty;
    LightParts parts;
    std::optional<FirstHit> first;  ///< only where a layer wants it
};

/// Sums of samples per pixel for the picture and its layers. Each pixel belongs to one thread at a time and its samples
/// come in order, so sums do not depend on threads.
class FilmSums {
public:
    /// layers: of layer_names(), in the order of the film. Throws Error(usage) with the nearest name of an unknown one,
    /// Error(limit) before anything is allocated where memory does not suffice.
    FilmSums(int width, int height, const std::vector<std::string>& layers);

    [[nodiscard]] bool wants_first_hit() const noexcept { return wants_first_hit_; }
    void add(std::size_t pixel, const PixelSample& sample) noexcept;
    /// The picture so far; the pixel has had samples[pixel] samples. Ends the sums' life.
    [[nodiscard]] Film finish(const std::vector<std::uint32_t>& samples) &&;
    /// Beauty summed over the samples so far.
    [[nodiscard]] Rgb beauty_sum(std::size_t pixel) const noexcept;

private:
    /// How a layer takes its samples.
    enum class Kind { beauty, direct, indirect, caustic, specular, emission, normal, depth, albedo, region };
    static Kind kind_of(const std::string& name);
    static int channels_of(Kind kind);
    void add_to(std::size_t layer, std::size_t pixel, const PixelSample& sample) noexcept;

    Film film_;
    std::vector<Kind> kinds_;
    std::vector<std::uint32_t> hits_;  ///< samples with a surface, for depth
    bool wants_first_hit_ = false;
};

}  // namespace cardioid
