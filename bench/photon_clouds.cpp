#include "bench/photon_clouds.hpp"

#include <algorithm>
#include <random>

namespace cardioid::bench {
namespace {

using photon::Photon;

constexpr std::size_t query_count = 1U << 18;

class Random {
public:
    float next() { return unit_float(static_cast<std::uint32_t>(bits_())); }
    std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(bits_() % n); }

private:
    std::mt19937 bits_{1};
};

Photon on_wall(Random& random) {
    const std::uint32_t wall = random.below(6);
    Photon photon{};
    photon.p = {random.next(), random.next(), random.next()};
    Vec3 n;
    const int axis = static_cast<int>(wall / 2);
    photon.p[axis] = static_cast<float>(wall % 2);
    n[axis] = wall % 2 ? -1.0F : 1.0F;
    photon.n = photon::encode_direction(n);
    return photon;
}

/// On the floor, where light from far away goes after a cylinder has reflected it (a tenth lies anywhere).
Photon in_caustic(Random& random) {
    Photon photon = on_wall(random);
    photon.n = photon::encode_direction({0, 0, 1});
    photon.p.z = 0;
    if (random.below(10) == 0) return photon;
    const float phi = pi * random.next(), width = 0.004F * (random.next() + random.next() - 1);
    const float along = 0.25F * random.next() * random.next();
    const float x = 0.75F * std::cos(phi) - 0.25F * std::cos(3 * phi);
    const float y = 0.75F * std::sin(phi) - 0.25F * std::sin(3 * phi);
    photon.p.x = 0.5F + 0.4F * x * (1 - along) + width;
    photon.p.y = 0.1F + 0.4F * y * (1 - along);
    return photon;
}

std::uint64_t spread(float x) {
    auto bits = static_cast<std::uint64_t>(std::clamp(x, 0.0F, 0.999999F) * 0x1p21F);
    bits = (bits | bits << 32) & 0x1F00000000FFFFULL;
    bits = (bits | bits << 16) & 0x1F0000FF0000FFULL;
    bits = (bits | bits << 8) & 0x100F00F00F00F00FULL;
    bits = (bits | bits << 4) & 0x10C30C30C30C30C3ULL;
    return (bits | bits << 2) & 0x1249249249249249ULL;
}
std::uint64_t morton(Vec3 p) { return spread(p.x) | spread(p.y) << 1 | spread(p.z) << 2; }

template <class Draw>
PhotonCloud cloud(std::size_t n, Draw draw) {
    Random random;
    PhotonCloud c;
    c.photons.resize(n);
    for (Photon& photon : c.photons) photon = draw(random);
    c.random.resize(query_count);
    for (Place& place : c.random) {
        const Photon photon = draw(random);
        place = {photon.p, photon::decode_direction(photon.n)};
    }
    c.morton = c.random;
    std::ranges::sort(c.morton, {}, [](const Place& place) { return morton(place.p); });
    return c;
}

}  // namespace

PhotonCloud wall_cloud(std::size_t n) { return cloud(n, on_wall); }
PhotonCloud caustic_cloud(std::size_t n) { return cloud(n, in_caustic); }

}  // namespace cardioid::bench
