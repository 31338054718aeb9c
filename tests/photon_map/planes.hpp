#pragma once
#include <functional>

#include "photon/map/photon_map.hpp"
#include "tests/photon_map/clouds.hpp"
#include "tests/photon_map/statistics.hpp"

namespace cardioid::photon::test {

/// Photons on pieces of planes: true irradiance is known, and what a lookup says of it is measured.
class PhotonScene {
public:
    explicit PhotonScene(std::uint32_t seed) : random_(seed) {}
    /// About `density` photons per unit area on the parallelogram p + u [0,1] + v [0,1], each of flux 1 / unit_density,
    /// so that irradiance is density / unit_density; `strength(x, y)` in [0, 1] thins them out, x and y in [0, 1].
    void add(
        Vec3 p, Vec3 u, Vec3 v, Vec3 n, double density,
        const std::function<double(double, double)>& strength = [](double, double) { return 1.0; }) {
        const double area = double{length(cross(u, v))};
        const auto count = std::poisson_distribution<int>(density * area)(bits_);
        for (int i = 0; i < count; ++i) {
            const float x = random_.next(), y = random_.next();
            if (strength && double{random_.next()} >= strength(double{x}, double{y})) continue;
            Photon photon{};
            photon.p = p + u * x + v * y;
            photon.n = photon.wi = encode_direction(n);
            photon.flux = encode_flux(Rgb(1), 1);
            photons_.push_back(photon);
        }
    }
    [[nodiscard]] PhotonMap map(double unit_density) const {
        return {photons_, {}, static_cast<float>(1 / unit_density)};
    }
    Random& random() { return random_; }

private:
    Random random_;
    std::mt19937 bits_{random_.below(0x7FFFFFFFU)};
    std::vector<Photon> photons_;
};

inline SurfacePoint point_at(Vec3d p, Vec3 n) {
    SurfacePoint point;
    point.p = p;
    point.ng = n;
    point.frame = Frame(n);
    return point;
}

}  // namespace cardioid::photon::test
