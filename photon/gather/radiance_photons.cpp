#include "photon/gather/radiance_photons.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "photon/gather/incoming_light.hpp"
#include "photon/gather/photon_surface.hpp"
#include "photon/gather/side.hpp"
#include "photon/hemisphere/hemisphere.hpp"
#include "rt_core/api/parallel.hpp"

namespace cardioid::photon {

namespace {

/// Places that one thread works out at a time.
constexpr std::size_t chunk_size = 256;
/// A place reaches to so many others around it, of which one is then nearer all but e^-8 of the time.
constexpr std::uint32_t others = 8;
/// Photons that a lookup has to expect, for a standard error of 25 %.
constexpr float fewest_photons = 16;
/// Once it is gathered, a place tells of what is as near as places are to one another: this share of their reach.
constexpr float blur = 0.3F;
/// Keeps the random numbers of gathers apart from those of direct light.
constexpr std::uint32_t gathers = 1U << 29;

/// A radiance photon in the making.
struct Draft {
    RadiancePhoton place;
    SurfacePoint point;
    Vec3 w;                ///< a direction on the lit side
    Rgb own;               ///< what is not looked up again: from lamps, and caustics
    std::uint64_t number;  ///< of its random numbers
};

/// Each place's reach becomes the radius of the smallest disc about it that has so many points of the tree; where that
/// is wider than `widest` the place is left out.
template <class Point>
void set_reach(std::vector<RadiancePhoton>& places, const PointTree<Point>& tree, std::uint32_t points, float widest) {
    parallel_for(static_cast<std::int64_t>(places.size()), [&](std::int64_t i) {
        RadiancePhoton& place = places[static_cast<std::size_t>(i)];
        thread_local Neighbours found;
        PointQuery query = same_surface(place.p, decode_direction(place.n), place.region);
        query.max_radius = widest;
        tree.nearest(query, points, found);
        place.reach = found.size < points ? 0 : std::sqrt(*std::max_element(found.d2, found.d2 + found.size));
    });
    std::erase_if(places, [](const RadiancePhoton& place) { return !(place.reach > 0); });
}

class Maker {
public:
    Maker(const World& world, const RadiancePlaces& at, const PhotonMap& map, const RadianceRule& rule,
          Progress& progress)
        : world_(world), at_(at), map_(map), rule_(rule), progress_(progress) {}

    std::vector<RadiancePhoton> make() {
        estimate();
        if (progress_.interrupted()) return {};
        std::vector<RadiancePhoton> known = well_known();
        if (rule_.gather_rays == 0) return known;
        gather(RadianceMap(std::move(known), at_.origin));
        std::vector<RadiancePhoton> all = places();
        reach_others(all);
        for (RadiancePhoton& place : all) place.blur = blur * place.reach;
        return all;
    }

private:
    /// Calls work(i) for all i below count on all threads, a chunk at a time.
    template <class Work>
    void for_each(std::size_t count, double begin, double end, const Work& work) {
        const std::size_t chunks = (count + chunk_size - 1) / chunk_size;
        std::atomic<std::size_t> done{0};
        parallel_for(static_cast<std::int64_t>(chunks), [&](std::int64_t c) {
            if (progress_.interrupted()) return;
            const std::size_t first = static_cast<std::size_t>(c) * chunk_size;
            for (std::size_t i = first; i < std::min(first + chunk_size, count); ++i) work(i);
            progress_.update(begin + (end - begin) * static_cast<double>(++done) / static_cast<double>(chunks));
        });
    }

    void estimate() {
        drafts_.resize(at_.places.size());
        for_each(drafts_.size(), 0, 0.5, [&](std::size_t i) {
            const Photon& photon = at_.places[i];
            Draft& draft = drafts_[i];
            const auto point = surface_under(world_, photon, at_.origin);
            if (!point) return;
            draft.point = *point;
            draft.w = decode_direction(photon.wi);
            draft.number = i;
            const Vec3 ng = geometric_normal(*point, draft.w);
            BsdfMemory memory;
            const Bsdf& bsdf = *world_.bsdf(*point, memory);
            const Estimate rest = map_.irradiance(*point, ng, rule_.lookup, &world_, &bsdf);
            draft.own = from_lamps(*point, bsdf, ng, i);
            if (rule_.caustics)
                draft.own += rule_.caustics->irradiance(*point, ng, rule_.caustic_lookup, &world_, &bsdf).E;
            const Rgb E = draft.own + rest.E;
            if (is_finite(E)) draft.place = {photon.p, photon.n, photon.region, E, rest.radius, 0};
        });
        std::erase_if(drafts_, [](const Draft& draft) { return !(draft.place.blur > 0); });
    }

    [[nodiscard]] Rgb from_lamps(const SurfacePoint& point, const Bsdf& bsdf, Vec3 ng, std::uint64_t number) const {
        const DiffuseLobe white(bsdf, Rgb{pi});
        Rgb sum;
        for (std::uint32_t i = 0; i < rule_.light_rays; ++i) {
            Sampler sampler(rule_.seed, Purpose::gather, number, i);
            sum += world_.direct(point, white, ng, sampler);
        }
        return sum * (1 / static_cast<float>(rule_.light_rays));
    }

    [[nodiscard]] std::vector<RadiancePhoton> places() const {
        std::vector<RadiancePhoton> all(drafts_.size());
        for (std::size_t i = 0; i < all.size(); ++i) all[i] = drafts_[i].place;
        return all;
    }

    /// The places of which enough is known. Where the witnesses are tells that, and not how many photons of the map a
    /// lookup found: else lookups that found more by chance would be kept.
    [[nodiscard]] std::vector<RadiancePhoton> well_known() const {
        std::vector<RadiancePhoton> known = places();
        const float widest = rule_.lookup.max_radius * std::sqrt(others / (fewest_photons * rule_.share));
        set_reach(known, PointTree<Photon>(at_.witnesses), others, widest);
        reach_others(known);
        return known;
    }

    /// Gives each place its reach.
    void reach_others(std::vector<RadiancePhoton>& places) const {
        set_reach(places, PointTree<RadiancePhoton>(places), others + 1, rule_.lookup.max_radius);
    }

    /// Puts a small gather over the known places in the stead of what the map told of each. Of places of which it told
    /// too little nothing was known: there the rays go on until they find one.
    void gather(const RadianceMap& known) {
        const IncomingLight light(world_, {.radiance = &known,
                                           .caustics = rule_.caustics,
                                           .caustic_lookup = rule_.caustic_lookup,
                                           .broad_apart = rule_.broad_apart});
        const Hemisphere hemisphere = Hemisphere::of(rule_.gather_rays);
        for_each(drafts_.size(), 0.5, 1, [&](std::size_t i) {
            Draft& draft = drafts_[i];
            const Rgb E = draft.own + gathered(draft, hemisphere, light);
            if (is_finite(E)) draft.place.E = E;
        });
    }

    [[nodiscard]] Rgb gathered(const Draft& draft, const Hemisphere& hemisphere, const IncomingLight& light) const {
        const Frame frame(shading_normal(draft.point, draft.w));
        const Vec3 ng = geometric_normal(draft.point, draft.w);
        BsdfMemory memory;
        const Bsdf& bsdf = *world_.bsdf(draft.point, memory);
        Rgb sum;
        for (int j = 0, i = 0; j < hemisphere.rings; ++j)
            for (int k = 0; k < hemisphere.sectors; ++k, ++i) {
                Sampler sampler(rule_.seed, Purpose::gather, draft.number, gathers + static_cast<std::uint32_t>(i));
                const Vec3 wi = frame.to_world(hemisphere.direction(j, k, sampler.next2()));
                if (!(dot(wi, ng) > 0)) continue;
                const float taken = bsdf.diffuse_acceptance(draft.point.frame.to_local(wi));
                sum += light.along(draft.point, wi, sampler).L * taken;
            }
        return sum * (pi / static_cast<float>(hemisphere.size()));
    }

    const World& world_;
    const RadiancePlaces& at_;
    const PhotonMap& map_;
    const RadianceRule& rule_;
    Progress& progress_;
    std::vector<Draft> drafts_;
};

}  // namespace

std::vector<RadiancePhoton> make_radiance_photons(const World& world, const RadiancePlaces& at, const PhotonMap& map,
                                                  const RadianceRule& rule, Progress& progress) {
    return Maker(world, at, map, rule, progress).make();
}

}  // namespace cardioid::photon
