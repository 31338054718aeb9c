#include "photon/emission/emit.hpp"

namespace cardioid::photon {

namespace {

/// The numbers that sample_sphere turns into a direction drawn by rejection from the ball: its directions are uniform,
/// those of a cube or an octahedron would not be (the report leaves open which is meant; see docs/photon-mapping.md).
Vec2 reject_from_ball(Sampler& sampler) {
    for (;;) {
        const Vec2 xy = sampler.next2();
        const Vec3 p{2 * xy.x - 1, 2 * xy.y - 1, 2 * sampler.next() - 1};
        const float r2 = dot(p, p);
        if (!(r2 <= 1) || !(r2 > 0)) continue;
        const float turn = std::atan2(p.y, p.x) / (2 * pi);
        constexpr float below_one = 0x1.fffffep-1F;
        return {std::min((1 - p.z / std::sqrt(r2)) / 2, below_one), std::min(turn < 0 ? turn + 1 : turn, below_one)};
    }
}

}  // namespace

EmissionNumbers draw_emission(Directions directions, Sampler& sampler) noexcept {
    const Vec2 place = sampler.next2();
    return {place, directions == Directions::ball ? reject_from_ball(sampler) : sampler.next2()};
}

}  // namespace cardioid::photon
