#pragma once
#include <cmath>
#include <random>
#include <vector>

#include "photon/map/photon.hpp"

namespace cardioid::photon::test {

/// Numbers in [0, 1) that are independent of the program's own sampler; fixed, so that a failure can be run again.
class Random {
public:
    explicit Random(std::uint32_t seed = 1) : bits_(seed) {}
    float next() { return unit_float(static_cast<std::uint32_t>(bits_())); }
    Vec2 next2() {
        const float x = next();
        return {x, next()};
    }
    Vec3 next3() {
        const Vec2 v = next2();
        return {v.x, v.y, next()};
    }
    std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(bits_() % n); }

private:
    std::mt19937 bits_;
};

/// How the points of a cloud lie.
enum class Cloud { filled, walls, grid, line, one_place };
inline constexpr Cloud all_clouds[] = {Cloud::filled, Cloud::walls, Cloud::grid, Cloud::line, Cloud::one_place};

inline Vec3 place(Random& random, Cloud cloud) {
    Vec3 p = random.next3();
    switch (cloud) {
        case Cloud::filled:
            return p;
        case Cloud::walls: {
            const std::uint32_t wall = random.below(6);
            p[static_cast<int>(wall / 2)] = static_cast<float>(wall % 2);
            return p;
        }
        case Cloud::grid:  // many in the same place
            return {std::floor(p.x * 4) / 4, std::floor(p.y * 4) / 4, std::floor(p.z * 4) / 4};
        case Cloud::line:
            return {p.x * p.x * p.x * p.x, 0.25F, -3};
        case Cloud::one_place:
            return {0.5F, 0.5F, 0.5F};
    }
    return p;
}

inline std::vector<Photon> cloud_of(Cloud cloud, std::size_t n, std::uint32_t seed) {
    Random random(seed);
    std::vector<Photon> photons(n);
    for (std::size_t i = 0; i < n; ++i) {
        Photon& photon = photons[i];
        photon = {};
        photon.p = place(random, cloud);
        photon.n = encode_direction(sample_sphere(random.next2()));
        photon.region = random.below(3);
        photon.flux = static_cast<std::uint32_t>(i);  // tells photons apart
    }
    return photons;
}

}  // namespace cardioid::photon::test
