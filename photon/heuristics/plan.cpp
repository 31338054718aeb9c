#include "photon/heuristics/plan.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "photon/heuristics/counts.hpp"
#include "photon/heuristics/sights.hpp"
#include "photon/map/photon_map.hpp"
#include "photon/propagation/path_class.hpp"

namespace cardioid::photon {

namespace {

constexpr std::uint64_t pilot_count = 4096, largest_pilot = 1 << 18, caustic_pilot_count = 1 << 14, aim_paths = 1 << 17;
/// Photons of a lookup that feeds a final gather: its hundreds of rays average the noise away.
constexpr std::uint32_t gather_k = 50;
/// Largest radius of lookups as a share of the picture's width, and of those that a gather averages.
constexpr double seen_radius = 0.02, gathered_radius = 0.015, caustic_radius = 0.005;
/// Caustics that nobody looks at: a radius as a share of their own, for an error of 5 %. A disc blurs less the smaller
/// it is, but needs as many photons.
constexpr double caustic_share = 0.2, usual_error = 0.05;
/// So many times the radius are lookups allowed to go where caustics are dim: in a picture noise is worse than blur.
constexpr double seen_reach = 4, unseen_reach = 1.5;
/// The report's fixed radius, as a share of the scene's diagonal.
constexpr double report_radius = 0.05;
/// Indirect light that is gathered: of so many photons within that radius, were there no other light.
constexpr double gathered_k = 20;
/// Radius that caustics need not be sharper than, pixels: the disc of a photon is a pixel across.
constexpr double least_disc = 0.5;
/// What a picture is worth at least and at most, whatever it shows; the most of a small one.
constexpr double fewest = 20'000, most = 4e6, most_of_small = 4e5, most_a_pixel = 40;
constexpr std::uint32_t probe_k = 24;      ///< photons of the pilot that tell the density at a place
constexpr double places_satisfied = 0.75;  ///< share of the places seen that get the density they want

/// Photons per square unit at each of the places, 0 where there are too few; `by_share`: divided by the share of them
/// that are of indirect light.
std::vector<double> densities(const PhotonMap& map, const std::vector<Sighting>& places, bool by_share) {
    std::vector<double> found;
    WeighedPhotons near;
    for (const Sighting& s : places) {
        map.weigh(s.point, s.n, {.k = probe_k, .kernel = Kernel::box, .edge = EdgeRule::none}, nullptr, near);
        const double area = std::numbers::pi * double{near.radius} * double{near.radius};
        const double density = near.k == probe_k && area > 0 ? (probe_k - 1) / area : 0;
        std::uint32_t indirect = 0;
        for (std::uint32_t i = 0; i < near.found.size; ++i)
            if (path_class(map.tree().payload(near.found.index[i]).way) == PathClass::indirect) ++indirect;
        found.push_back(by_share ? density * (probe_k - 1) / std::max(indirect, 1U) : density);
    }
    return found;
}

/// What the given share of the places has more than.
double density_of_most(std::vector<double> d, double share) {
    if (d.empty()) return 0;
    const auto at = static_cast<std::ptrdiff_t>((1 - share) * static_cast<double>(d.size() - 1));
    std::nth_element(d.begin(), d.begin() + at, d.end());
    return d[static_cast<std::size_t>(at)];
}

/// Some of the photons as places.
std::vector<Sighting> places_of(const Shot& shot) {
    constexpr std::size_t enough = 512;
    const std::size_t stride = std::max<std::size_t>(shot.photons.size() / enough, 1);
    std::vector<Sighting> places;
    for (std::size_t i = 0; i < shot.photons.size(); i += stride) {
        Sighting s;
        s.n = decode_direction(shot.photons[i].n);
        s.point.p = shot.origin + Vec3d(shot.photons[i].p);
        s.point.ng = s.n;
        s.point.frame = Frame(s.n);
        s.point.id.region = shot.photons[i].region;
        places.push_back(s);
    }
    return places;
}

class Planner {
public:
    Planner(const World& world, const Eye* eye, const PhotonOptions& options, std::uint32_t seed, Progress& progress)
        : world_(world), options_(options), seed_(seed), progress_(progress), eye_(eye) {
        if (eye) {
            sights_ = look_around(*eye, seed);
            width_ = picture_width(sights_, *eye);
            most_ = most_for(*eye);
        }
        if (!(width_ > 0)) {
            width_ = world.bounds().diagonal() > 0 ? world.bounds().diagonal() : 1;
            of_what_ = "the scene's diagonal";
        }
    }

    Plan make() {
        lookups();
        global();
        caustics();
        plan_.caustic_reach = plan_.caustic_radius;
        if (!options_.caustic_radius && options_.mode == Mode::physical)
            plan_.caustic_reach *= eye_ ? seen_reach : unseen_reach;
        return std::move(plan_);
    }

private:
    [[nodiscard]] double most_for(const Eye& eye) const {
        if (options_.mode == Mode::report) return most;
        const double stricter = usual_error / options_.error;
        const double pixels = static_cast<double>(eye.width()) * eye.height();
        return std::clamp(most_a_pixel * pixels * stricter * stricter, most_of_small, most);
    }
    void note(const char* name, std::string value, std::string why) {
        plan_.derived.push_back({name, std::move(value), std::move(why)});
    }
    [[nodiscard]] Shot fly(Pass pass, Keep keep, std::uint64_t count) const {
        return shoot(world_, options_, {seed_, pass, keep, count, keep == Keep::caustics ? &plan_.aim : nullptr},
                     progress_);
    }

    void lookups() {
        const bool gathers = this->gathers();
        plan_.k = options_.k.value_or(gathers ? gather_k : lookup_size(options_.error));
        plan_.caustic_k = options_.caustic_k.value_or(lookup_size(2 * options_.error));
        const bool report = options_.mode == Mode::report;
        const double whole = report ? world_.bounds().diagonal() : width_;
        const double share = report ? report_radius : gathers ? gathered_radius : seen_radius;
        plan_.radius = options_.radius.value_or(whole > 0 ? share * whole : 1);
        finer_ = report ? 1 : std::cbrt(options_.error / usual_error);
        plan_.caustic_radius = options_.caustic_radius.value_or(report ? plan_.radius : sharp());
        const std::string k_why = gathers ? "a gather's rays average the noise"
                                          : fmt::format("1/{:g}^2 + 2, for photon.error", options_.error);
        if (!options_.k) note("k", fmt::format("{}", plan_.k), k_why);
        if (!options_.radius)
            note("radius", fmt::format("{:.4g}", plan_.radius),
                 fmt::format("{:g} of {}", share, report ? "the scene's diagonal" : of_what_));
    }

    [[nodiscard]] bool gathers() const { return options_.indirect != Indirect::map && options_.mode == Mode::physical; }

    /// Radius of a caustic's discs.
    [[nodiscard]] double sharp() const {
        const double wanted = caustic_radius * finer_ * width_;
        return eye_ ? std::max(wanted, least_disc * finer_ * width_ / std::max(eye_->width(), eye_->height())) : wanted;
    }

    void global() {
        const Shot pilot = fly(Pass::pilot, Keep::everything, pilot_count);
        const double emitted = static_cast<double>(std::max<std::uint64_t>(pilot.emitted, 1));
        const Ledger& ledger = pilot.ledger;
        plan_.stored_per_emitted = static_cast<double>(ledger.stored_photons()) / emitted;
        plan_.specular_share = static_cast<double>(ledger.specular_first) / emitted;
        const FluxSum& bright = ledger.stored[static_cast<std::size_t>(PathClass::caustic)];
        const double all = ledger.emitted.r + ledger.emitted.g + ledger.emitted.b;
        plan_.caustic_share = all > 0 ? (bright.r + bright.g + bright.b) / all : 0;
        note("stored_per_emitted", fmt::format("{:.3g}", plan_.stored_per_emitted),
             fmt::format("pilot of {} photons", pilot.emitted));
        plan_.count = bounded("count", options_.count.has_value(), wanted(pilot), plan_.stored_per_emitted);
    }

    /// Photons per square unit and photon emitted that three quarters of the places have. Where indirect light alone is
    /// made of them, their noise is a share of all light there, be it lamps' or caustics': for the same error as many
    /// photons are needed as are indirect among those that would do if all were. Flies larger pilots where
    /// this one left too few photons at so many; what is dark to the largest is not counted.
    [[nodiscard]] double density_at_most(const Shot& pilot) const {
        const PhotonMap map(pilot.photons, pilot.origin, pilot.flux_scale);
        std::vector<double> found = densities(map, sights_.empty() ? places_of(pilot) : sights_, by_share());
        double density = density_of_most(found, places_satisfied);
        if (density == 0 && pilot.emitted > 0 && pilot.emitted < largest_pilot && !progress_.interrupted())
            return density_at_most(fly(Pass::pilot, Keep::everything, pilot.emitted * 8));
        if (density == 0) {
            std::erase(found, 0.0);
            density = density_of_most(std::move(found), places_satisfied);
        }
        return density / static_cast<double>(std::max<std::uint64_t>(pilot.emitted, 1));
    }

    [[nodiscard]] bool by_share() const { return eye_ && gathers() && !options_.k; }

    [[nodiscard]] double wanted(const Shot& pilot) {
        if (options_.count) return static_cast<double>(*options_.count);
        if (options_.count_by_faces) {
            note("count", fmt::format("{}", report_count(world_.face_count())),
                 fmt::format("10,000 + {} faces / 100", world_.face_count()));
            return static_cast<double>(report_count(world_.face_count()));
        }
        const double stricter = usual_error / options_.error;
        const double k = by_share() ? gathered_k * stricter * stricter : plan_.k;
        const double count = std::clamp(count_for(k, plan_.radius, density_at_most(pilot)), fewest, most_);
        note("count", fmt::format("{:.0f}", count),
             fmt::format("{}{:.3g} photons within {:.4g} at three quarters of the places seen, {:.0f} to {:.0f}",
                         by_share() ? "for indirect light as sure as all light of " : "", k, plan_.radius, fewest,
                         most_));
        return count;
    }

    void caustics() {
        if (options_.caustic_count == std::uint64_t{0}) return;
        plan_.aim = find_aim(world_, options_, seed_, aim_paths, progress_);
        if (plan_.aim.empty()) {
            plan_.aim.cells.clear();
            note("caustic_count", "0", fmt::format("none of {} photons made a caustic", plan_.aim.paths));
            return;
        }
        if (!options_.aim_caustics) plan_.aim.cells.clear();
        const Shot pilot = fly(Pass::pilot, Keep::caustics, caustic_pilot_count);
        const double emitted = static_cast<double>(std::max<std::uint64_t>(pilot.emitted, 1));
        const double stored = static_cast<double>(pilot.ledger.stored_photons()) / emitted;
        const PhotonMap map(pilot.photons, pilot.origin, pilot.flux_scale);
        const double density = density_of_most(densities(map, places_of(pilot), false), 0.5) / emitted;
        if (!eye_ && options_.mode == Mode::physical && !options_.caustic_radius) fit_to_caustics(stored, density);
        caustic_notes();
        double count = static_cast<double>(options_.caustic_count.value_or(0));
        if (!options_.caustic_count) {
            count = std::clamp(count_for(plan_.caustic_k, plan_.caustic_radius, density), fewest, most_);
            note("caustic_count", fmt::format("{:.0f}", count),
                 fmt::format("{} photons within {:.4g} where half of the caustics' photons are", plan_.caustic_k,
                             plan_.caustic_radius));
        }
        plan_.caustic_count = bounded("caustic_count", options_.caustic_count.has_value(), count, stored);
    }

    /// No pixels bound what can be seen: discs are small beside the caustics themselves, of which half of the photons
    /// are in places of at least that density.
    void fit_to_caustics(double stored, double density) {
        if (!(density > 0)) return;
        const double half = std::sqrt(0.5 * stored / (std::numbers::pi * density));
        if (caustic_share * finer_ * half >= plan_.caustic_radius) return;
        plan_.caustic_radius = caustic_share * finer_ * half;
        of_caustics_ = half;
    }

    void caustic_notes() {
        if (!options_.caustic_k)
            note("caustic_k", fmt::format("{}", plan_.caustic_k),
                 fmt::format("1/(2 x {:g})^2 + 2, for photon.error", options_.error));
        if (!options_.caustic_radius)
            note("caustic_radius", fmt::format("{:.4g}", plan_.caustic_radius),
                 of_caustics_ > 0
                     ? fmt::format("{:.3g} of where half of the caustics' photons are, for photon.error",
                                   plan_.caustic_radius / of_caustics_)
                     : fmt::format("{:.3g} of {}, for photon.error", plan_.caustic_radius / width_, of_what_));
    }

    /// The count, or as many as memory holds where nobody asked for it. Throws Error(limit).
    [[nodiscard]] std::uint64_t bounded(const char* name, bool asked, double count, double stored_per_emitted) {
        constexpr double megabyte = 1e6;
        const double memory = options_.memory.value_or(default_memory());
        const double bytes = bytes_of(count * stored_per_emitted);
        if (bytes <= memory) return static_cast<std::uint64_t>(count);
        const std::string estimate = fmt::format("{:.0f} photons store about {:.3g} and need {:.0f} MB", count,
                                                 count * stored_per_emitted, bytes / megabyte);
        if (asked)
            throw Error(ErrorCode::limit,
                        fmt::format("photon.{}: {}, photon.memory is {:.0f} MB: ask for at most {:.3g}", name, estimate,
                                    memory / megabyte, count * memory / bytes));
        const double fits = std::max(1.0, count * memory / bytes);
        note(name, fmt::format("{:.0f}", fits),
             estimate + fmt::format(", photon.memory is {:.0f} MB", memory / megabyte));
        return static_cast<std::uint64_t>(fits);
    }

    const World& world_;
    const PhotonOptions& options_;
    std::uint32_t seed_;
    Progress& progress_;
    std::vector<Sighting> sights_;
    double most_ = most;      ///< photons of a map
    double width_ = 0;        ///< scene units that are one picture wide
    double of_caustics_ = 0;  ///< radius of a disc as large as where half of the caustics' photons are, if it counts
    double finer_ = 1;        ///< caustics are looked up in discs so much smaller than for an error of 5 %
    const Eye* eye_;
    const char* of_what_ = "the picture's width";
    Plan plan_;
};

}  // namespace

Plan make_plan(const World& world, const Eye* eye, const PhotonOptions& options, std::uint32_t seed,
               Progress& progress) {
    return Planner(world, eye, options, seed, progress).make();
}

}  // namespace cardioid::photon
