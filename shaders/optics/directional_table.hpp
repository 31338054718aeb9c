#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace cardioid::shaders {

/// A smooth function of a direction's cosine in [0, 1], tabulated, denser towards grazing directions where reflectance
/// changes fast. T: float or Rgb.
template <class T>
class DirectionalTable {
public:
    DirectionalTable() = default;
    /// f(cosine) -> T, called for cosines in (0, 1].
    template <class F>
    explicit DirectionalTable(const F& f) {
        for (std::size_t i = 0; i <= cells; ++i) {
            const double t = static_cast<double>(i) / cells;
            values_[i] = f(std::max(t * t, 1e-6));
        }
    }
    [[nodiscard]] T operator()(float cosine) const noexcept {
        const float x = std::sqrt(std::clamp(cosine, 0.0F, 1.0F)) * static_cast<float>(cells);
        const std::size_t i = std::min(static_cast<std::size_t>(x), cells - 1);
        const float part = x - static_cast<float>(i);
        return values_[i] * (1 - part) + values_[i + 1] * part;
    }

private:
    static constexpr std::size_t cells = 96;
    std::array<T, cells + 1> values_{};
};

}  // namespace cardioid::shaders
