#include "photon/heuristics/sights.hpp"

#include <algorithm>

namespace cardioid::photon {

std::vector<Sighting> look_around(const Eye& eye, std::uint32_t seed) {
    constexpr std::uint32_t side = 16;  ///< film points a row
    const Eye::Crop crop = eye.crop();
    std::vector<Sighting> sights;
    for (std::uint32_t i = 0; i < side * side; ++i) {
        Sampler sampler(seed, Purpose::statistics, 0, i);
        const Vec2 jitter = sampler.next2();
        const double x = (i % side + double{jitter.x}) / side, y = (i / side + double{jitter.y}) / side;
        eye.look({crop.x0 + x * (crop.x1 - crop.x0), crop.y0 + y * (crop.y1 - crop.y0)}, sampler,
                 [&](const Eye::Sight& s) {
                     const bool outer = dot(s.point.ng, s.wo) >= 0;
                     sights.push_back({s.point, outer ? s.point.ng : -s.point.ng});
                 });
    }
    return sights;
}

double picture_width(const std::vector<Sighting>& sights, const Eye& eye) {
    std::vector<double> pixels;
    for (const Sighting& s : sights)
        if (s.point.footprint > 0) pixels.push_back(s.point.footprint);
    if (pixels.empty()) return 0;
    const auto middle = pixels.begin() + static_cast<std::ptrdiff_t>(pixels.size() / 2);
    std::nth_element(pixels.begin(), middle, pixels.end());
    return *middle * std::max(eye.width(), eye.height());
}

}  // namespace cardioid::photon
