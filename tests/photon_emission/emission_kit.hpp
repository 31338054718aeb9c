#pragma once
#include <cmath>

#include "photon/emission/shoot.hpp"
#include "rt_core/api/eye.hpp"
#include "tests/render/scene_kit.hpp"

namespace cardioid::test {

/// An empty room from lo to hi whose walls are one unit thick and of `inside` material.
inline std::uint32_t room(SceneKit& kit, Vec3d lo, Vec3d hi, std::uint32_t inside) {
    const Vec3d wall{1, 1, 1};
    return kit.scene.solids.add_node(SolidOp::subtract,
                                     {kit.box(lo - wall, hi + wall, inside), kit.box(lo, hi, inside)});
}

/// Light from the middle of a closed unit room with the named kind of wall.
inline SceneKit lit_room(const std::string& kind,
                         std::initializer_list<std::pair<const char*, std::vector<double>>> values) {
    SceneKit kit;
    kit.root(room(kit, {0, 0, 0}, {1, 1, 1}, kit.material("wall", kind, values)));
    kit.light("point_light", {{"power", {3, 2, 1}}}, Affine::translation({0.5, 0.4, 0.6}));
    return kit;
}

inline photon::Shot shoot(const World& world, std::uint64_t count, const photon::PhotonOptions& options = {},
                          photon::Keep keep = photon::Keep::everything, std::uint32_t seed = 1) {
    Progress progress;
    return photon::shoot(world, options, {.seed = seed, .keep = keep, .count = count}, progress);
}

inline Vec3d place(const photon::Shot& shot, const photon::Photon& photon) { return shot.origin + Vec3d(photon.p); }
inline Rgb flux(const photon::Shot& shot, const photon::Photon& photon) {
    return photon::decode_flux(photon.flux, shot.flux_scale);
}

/// Sees one place wherever it looks.
class StaringEye final : public Eye {
public:
    StaringEye(const World& world, const Ray& ray, int side = 8)
        : world_(world), point_(world.surface(ray, world.intersect(ray))), side_(side) {}
    [[nodiscard]] int width() const noexcept override { return side_; }
    [[nodiscard]] int height() const noexcept override { return side_; }
    [[nodiscard]] Crop crop() const noexcept override { return {0, 0, side_, side_}; }
    void look(Vec2d /*film*/, Sampler& /*sampler*/, const std::function<void(const Sight&)>& see) const override {
        BsdfMemory memory;
        see({point_, *world_.bsdf(point_, memory), point_.ng, Rgb(1), 0});
    }

private:
    const World& world_;
    SurfacePoint point_;
    int side_;
};

/// Two-sided p-value of a mean that lies z standard errors away.
inline double p_of_z(double z) { return std::erfc(std::abs(z) / std::numbers::sqrt2); }

}  // namespace cardioid::test
