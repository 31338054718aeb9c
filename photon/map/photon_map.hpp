#pragma once
#include <span>
#include <vector>

#include "photon/map/photon.hpp"
#include "photon/map/tree/point_tree.hpp"
#include "photon/options/choices.hpp"
#include "rt_core/api/world.hpp"

namespace cardioid::photon {

/// How a lookup gathers photons and turns them into light. Defaults are those of `mode = physical`.
struct LookupRule {
    std::uint32_t k = 50;  ///< photons wanted, the one that sets the radius included; 2 to Neighbours::max_k
    bool spread = false;   ///< photons light the discs that PhotonMap::spread() gave them; k and radius are theirs
    float max_radius = std::numeric_limits<float>::infinity();  ///< > 0, scene units
    bool fixed_radius =
        false;                ///< max_radius (finite) whatever it holds, up to Neighbours::max_k photons; k is not read
    bool count_last = false;  ///< the photon that sets the radius counts too: 1/(k - 1) too much (report [7c])
    Kernel kernel = Kernel::epanechnikov;
    EdgeRule edge = EdgeRule::hull;
    float least_cos = 0.5F;    ///< of the angle between the normals of photon and surface, in [0, 1] (report [7b])
    float steepness = 0.25F;   ///< a photon may be so far off the plane for a unit of distance within it
    float flatten = 1;         ///< distances off the plane count this many times; past 1 curved surfaces get too dark
    bool same_region = false;  ///< photons of other solids do not count (report 6.2)
};

/// Irradiance from the photons near a point, and how sure of it we are.
struct Estimate {
    Rgb E;                ///< W per square scene unit
    Rgb variance;         ///< of E, estimated: the sum of the squares of what each photon adds
    float radius = 0;     ///< of the disc that held the photons, scene units
    std::uint32_t k = 0;  ///< photons that passed the tests, the one that set the radius included; 0 is no error
};

/// Photons that a lookup found, with the share of each.
struct WeighedPhotons {
    Neighbours found;  ///< found.d2[i] has become the weight of photon found.index[i], per square scene unit
    float radius = 0;
    std::uint32_t k = 0;  ///< as in Estimate
    [[nodiscard]] float weight(std::uint32_t i) const noexcept { return found.d2[i]; }
};

/// Where photons met surfaces; read-only once built, so any thread may look up.
/// Estimates follow Jensen 2001, eq. 7.5, without the k-th photon, which only sets the radius (else +1/(k-1) bias).
class PhotonMap {
public:
    PhotonMap() = default;
    /// `origin` is what positions of photons are relative to, `flux_scale` what their fluxes were encoded with.
    /// Throws Error(bad_input) where a position is not finite, Error(limit) past 2^30 photons.
    PhotonMap(std::span<const Photon> photons, Vec3d origin, float flux_scale);

    /// Gives each photon a disc of its own to light (spread.hpp), by rule.k and rule.max_radius; what `spread` lookups
    /// read. Not while others look up.
    void spread(const LookupRule& rule);

    /// Irradiance at `point` on the side that the unit vector n (its geometric normal or the opposite) is on.
    /// `world` is for EdgeRule::probe alone; without it, that rule is `hull`. With `taker`, each direction counts as
    /// its diffuse lobe takes it (Bsdf::diffuse_acceptance).
    [[nodiscard]] Estimate irradiance(const SurfacePoint& point, Vec3 n, const LookupRule& rule,
                                      const World* world = nullptr, const Bsdf* taker = nullptr) const noexcept;
    /// Radiance that leaves: the sum of f(wi) times what each photon brings; f has no cosine, wi is in the world.
    template <class F>
    [[nodiscard]] Rgb radiance(const SurfacePoint& point, Vec3 n, const LookupRule& rule, const F& f,
                               const World* world = nullptr) const noexcept {
        WeighedPhotons photons;
        weigh(point, n, rule, world, photons);
        Rgb L;
        for (std::uint32_t i = 0; i < photons.found.size; ++i) {
            const std::uint32_t p = photons.found.index[i];
            L += f(direction(p)) * flux(p) * photons.weight(i);
        }
        return L;
    }
    /// The query for photons around a place, relative to origin().
    [[nodiscard]] PointQuery query(Vec3 p, Vec3 n, std::uint32_t region, const LookupRule& rule) const noexcept;
    /// What both are made of: for other sums over photons.
    void weigh(const SurfacePoint& point, Vec3 n, const LookupRule& rule, const World* world,
               WeighedPhotons& out) const noexcept;

    [[nodiscard]] const PointTree<Photon>& tree() const noexcept { return tree_; }
    [[nodiscard]] std::uint32_t size() const noexcept { return tree_.size(); }
    [[nodiscard]] Vec3d origin() const noexcept { return origin_; }
    [[nodiscard]] float flux_scale() const noexcept { return flux_scale_; }
    /// Flux [W] of the photon i of the tree, where it came from (unit), and its place in the world.
    [[nodiscard]] Rgb flux(std::uint32_t i) const noexcept { return decode_flux(tree_.payload(i).flux, flux_scale_); }
    [[nodiscard]] Vec3 direction(std::uint32_t i) const noexcept { return decode_direction(tree_.payload(i).wi); }
    [[nodiscard]] Vec3d position(std::uint32_t i) const noexcept { return origin_ + Vec3d(tree_.position(i)); }
    /// The photons as they were given, in the order of the tree; a map made of them is the same.
    [[nodiscard]] std::vector<Photon> photons() const;
    [[nodiscard]] std::size_t memory_bytes() const noexcept { return tree_.memory_bytes() + reach_.memory_bytes(); }

private:
    /// Heights about p, relative to origin(), that may be rounding.
    [[nodiscard]] float slack(Vec3 p) const noexcept;
    void weigh_spread(const SurfacePoint& point, Vec3 n, const LookupRule& rule, const World* world,
                      WeighedPhotons& out) const noexcept;
    /// Of the weight of the disc, what probes reach; drops photons that they cannot see.
    [[nodiscard]] float reached_share(const World& world, const SurfacePoint& point, Vec3 n, const LookupRule& rule,
                                      WeighedPhotons& photons) const noexcept;

    PointTree<Photon> tree_;
    KdReach reach_;  ///< radii of the photons' own discs
    Vec3d origin_;
    float flux_scale_ = 1;
    float distance_ = 0;  ///< of half of the photons from the origin
};

}  // namespace cardioid::photon
