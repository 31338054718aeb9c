#pragma once
#include "photon/map/tree/point_query.hpp"
#include "rt_core/api/world.hpp"

namespace cardioid::photon {

/// The disc that a lookup gathers photons from: what of it is surface that can be reached.
struct ProbeDisc {
    SurfacePoint point;
    Vec3 n;                  ///< unit: the side that is looked at
    float radius = 0;        ///< > 0, scene units
    float least_cos = 0.5F;  ///< what counts as the same surface: as in LookupRule
    float steepness = 0.25F;
    float slack = 0;  ///< height that is always allowed, scene units
    bool same_region = false;
    std::uint64_t turn = 0;  ///< any number: how the pattern of probes is turned
};

/// Short rays from a little above a point to places of the disc around it (they stand in for the area that ARL-TR-3608,
/// notes [8] and [11], divide by): a place is reached where the ray meets the surface there, it is missing where there
/// is none (past an edge), and hidden where something stands in between. Any thread may use one.
class SurfaceProbe {
public:
    SurfaceProbe(const World& world, const ProbeDisc& disc) noexcept;

    /// Whether twelve places around the rim are all reached: then no edge comes nearer than 0.92 of the radius.
    [[nodiscard]] bool rim_reached() const noexcept;
    /// Share of the weight of the disc that can be reached, by `places` probes; `weight(t2)` is that of a place at
    /// sqrt(t2) radii. 0 where none is.
    template <class Weight>
    [[nodiscard]] float reached_share(const Weight& weight) noexcept {
        float reached = 0, all = 0;
        for (std::uint32_t i = 0; i < places; ++i) {
            const float t2 = (static_cast<float>(i) + 0.5F) / places;
            const float w = weight(t2);
            all += w;
            if (reaches(place(i)) == Sight::reached) reached += w;
        }
        return all > 0 ? reached / all : 0;
    }
    /// Whether reached_share() met something that hides part of the disc, so that photons may be hidden too.
    [[nodiscard]] bool something_hides() const noexcept { return something_hides_; }
    /// Whether the way from above the point to p (on the surface) is free.
    [[nodiscard]] bool sees(Vec3d p) const noexcept;

    static constexpr std::uint32_t places = 64;

private:
    enum class Sight { reached, missing, hidden };
    [[nodiscard]] Vec3d place(std::uint32_t i) const noexcept;
    [[nodiscard]] Vec3d on_plane(double r, double phi) const noexcept;
    [[nodiscard]] bool same_surface(const Ray& ray, const Hit& hit) const noexcept;
    [[nodiscard]] Sight look(Vec3d p) const noexcept;
    [[nodiscard]] Sight reaches(Vec3d p) noexcept;

    const World& world_;
    const ProbeDisc& disc_;
    Frame frame_;
    double turn_;
    Vec3d eye_;  ///< above the point, below what is above it
    bool something_hides_ = false;
};

}  // namespace cardioid::photon
