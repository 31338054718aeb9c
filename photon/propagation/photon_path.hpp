#pragma once
#include <vector>

#include "photon/options/photon_options.hpp"
#include "photon/propagation/ledger.hpp"
#include "photon/propagation/roulette.hpp"

namespace cardioid::photon {

/// Which photons a pass is for.
enum class Keep : std::uint8_t {
    everything,  ///< all classes: the global map
    caustics,    ///< those of mirrors and glass alone; paths end at the first diffuse scattering
};

/// Where and how photons are written.
struct StoreRule {
    Keep keep = Keep::everything;
    PathClasses unwanted{};   ///< counted, not kept
    bool broad_apart = true;  ///< Way::broad is noted
    Store which = Store::all;
    Vec3d origin;             ///< positions are relative to it
    float scale = 1;          ///< of encode_flux
    float least_breadth = 0;  ///< of what glossy lobes pass on [sr]
};

/// Follows photons from surface to surface, keeps those that fall on a surface with lobes of finite width, and accounts
/// for their flux. For one thread; what it gathers is taken from its public members.
class PhotonPath {
public:
    PhotonPath(const World& world, RouletteRule rule, const StoreRule& store)
        : world_(world), rule_(rule), store_(store) {}

    /// Follows one photon of `light`, of `flux` [W] along `ray`, until the roulette ends it. Throws std::bad_alloc
    /// only.
    void follow(const Light& light, Ray ray, Rgb flux, Sampler& sampler);

    std::vector<Photon> photons;
    Ledger ledger;

private:
    struct Leg;
    [[nodiscard]] bool step(Leg& leg, Sampler& sampler);
    [[nodiscard]] bool bounce(Leg& leg, const SurfacePoint& point, const Bsdf& bsdf, Sampler& sampler);
    void keep(Leg& leg, const SurfacePoint& point);
    [[nodiscard]] static Breadth breadth(const Leg& leg);
    void turn(Leg& leg, const SurfacePoint& point, const Bsdf& bsdf, const Scattered& next) const;

    const World& world_;
    RouletteRule rule_;
    StoreRule store_;
};

}  // namespace cardioid::photon
