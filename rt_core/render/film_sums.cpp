#include "rt_core/render/film_sums.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "rt_core/render/memory_limit.hpp"
#include "rt_core/scene/nearest_name.hpp"

namespace cardioid {

const std::vector<std::string>& layer_names() {
    static const std::vector<std::string> names{"direct", "indirect", "caustic", "specular", "emission",
                                                "normal", "depth",    "albedo",  "region"};
    return names;
}

FilmSums::Kind FilmSums::kind_of(const std::string& name) {
    const auto& names = layer_names();
    const auto at = std::find(names.begin(), names.end(), name);
    if (at == names.end()) {
        const std::vector<std::string_view> views(names.begin(), names.end());
        throw Error(ErrorCode::usage, fmt::format("no picture layer \"{}\"{}; there are {}", name,
                                                  did_you_mean(name, views), fmt::join(names, ", ")));
    }
    return static_cast<Kind>(at - names.begin() + 1);
}

int FilmSums::channels_of(Kind kind) { return kind == Kind::depth || kind == Kind::region ? 1 : 3; }

FilmSums::FilmSums(int width, int height, const std::vector<std::string>& layers) {
    kinds_.push_back(Kind::beauty);
    std::vector<std::string> names{""};
    for (const std::string& name : layers) {
        if (std::find(names.begin(), names.end(), name) != names.end()) continue;
        kinds_.push_back(kind_of(name));
        names.push_back(name);
    }
    int floats = 2;  // the counts of samples and of hits
    for (const Kind kind : kinds_) floats += channels_of(kind);
    const double pixels = static_cast<double>(width) * height;
    require_memory(pixels * floats * sizeof(float), fmt::format("a picture of {} x {} pixels", width, height));

    film_.width = width;
    film_.height = height;
    const auto n = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    for (std::size_t i = 0; i < kinds_.size(); ++i) {
        const int channels = channels_of(kinds_[i]);
        const float start = kinds_[i] == Kind::region ? -1 : 0;
        film_.layers.push_back({names[i], channels, std::vector<float>(n * static_cast<std::size_t>(channels), start)});
        wants_first_hit_ = wants_first_hit_ || kinds_[i] >= Kind::normal;
        if (kinds_[i] == Kind::depth) hits_.resize(n);
    }
}

void FilmSums::add_to(std::size_t layer, std::size_t pixel, const PixelSample& sample) noexcept {
    const Kind kind = kinds_[layer];
    float* at = film_.layers[layer].pixels.data() + pixel * static_cast<std::size_t>(channels_of(kind));
    const auto add_rgb = [&](Rgb c) { at[0] += c.r, at[1] += c.g, at[2] += c.b; };
    switch (kind) {
        case Kind::beauty:
            return add_rgb(sample.beauty);
        case Kind::direct:
            return add_rgb(sample.parts.direct);
        case Kind::indirect:
            return add_rgb(sample.parts.indirect);
        case Kind::caustic:
            return add_rgb(sample.parts.caustic);
        case Kind::specular:
            return add_rgb(sample.parts.specular);
        case Kind::emission:
            return add_rgb(sample.parts.emission);
        default:
            break;
    }
    if (!sample.first) return;
    const SurfacePoint& point = sample.first->point;
    switch (kind) {
        case Kind::normal:
            return add_rgb({point.frame.n.x, point.frame.n.y, point.frame.n.z});
        case Kind::albedo:
            return add_rgb(sample.first->albedo.total());
        case Kind::depth:
            at[0] += static_cast<float>(sample.first->distance);
            ++hits_[pixel];
            return;
        case Kind::region:
            if (at[0] < 0) at[0] = static_cast<float>(point.id.region);
            return;
        default:
            return;
    }
}

void FilmSums::add(std::size_t pixel, const PixelSample& sample) noexcept {
    for (std::size_t layer = 0; layer < kinds_.size(); ++layer) add_to(layer, pixel, sample);
}

Rgb FilmSums::beauty_sum(std::size_t pixel) const noexcept {
    const float* at = film_.layers[0].pixels.data() + pixel * 3;
    return {at[0], at[1], at[2]};
}

Film FilmSums::finish(const std::vector<std::uint32_t>& samples) && {
    for (std::size_t layer = 0; layer < kinds_.size(); ++layer) {
        if (kinds_[layer] == Kind::region) continue;
        const auto& counts = kinds_[layer] == Kind::depth ? hits_ : samples;
        const auto channels = static_cast<std::size_t>(channels_of(kinds_[layer]));
        std::vector<float>& pixels = film_.layers[layer].pixels;
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            const std::uint32_t n = counts[i / channels];
            if (n > 0) pixels[i] /= static_cast<float>(n);
        }
    }
    return std::move(film_);
}

}  // namespace cardioid
