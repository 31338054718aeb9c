#include "rt_core/render/measure/energy_ledger.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "rt_core/api/parallel.hpp"
#include "rt_core/render/lighting/roulette.hpp"

namespace cardioid {

namespace {

/// Pieces of work, each with its own books.
constexpr std::uint64_t pieces = 64;
/// A path goes on for sure while it has this share of its flux; below, the roulette keeps it there.
constexpr float sure_share = 0.05F;
/// Surfaces after which a path ends in any case.
constexpr int most_steps = 10'000;
/// Materials that gain less than this share of what they receive are not worth a word.
constexpr double worth_telling = 1e-4;
constexpr double beyond_doubt = 5, power_tolerance = 0.01;

Flux flux_of(Rgb c) { return {{double{c.r}, double{c.g}, double{c.b}}}; }

bool is_bad(Rgb c) { return !is_finite(c) || min_component(c) < 0; }

/// Books of one piece of work.
struct Books {
    struct Material {
        Flux received, absorbed;
        double path = 0;     ///< taken from the path under way, all channels
        double squares = 0;  ///< of what was taken from each path
    };
    Flux emitted, escaped, cut_off;
    std::uint64_t bad = 0;
    std::vector<Material> materials;
    std::vector<std::uint32_t> touched;  ///< materials of the path under way; may name one twice

    void absorb(std::uint32_t material, Flux flux) {
        materials[material].absorbed += flux;
        materials[material].path += flux.sum();
        touched.push_back(material);
    }
    void end_path() {
        for (const std::uint32_t m : touched) {
            materials[m].squares += materials[m].path * materials[m].path;
            materials[m].path = 0;
        }
        touched.clear();
    }
};

class Audit {
public:
    Audit(const World& world, std::uint32_t seed, std::uint32_t paths) : world_(world), seed_(seed) {
        double total = 0;
        for (const auto& light : world.lights()) total += luminance(light->power());
        for (const auto& light : world.lights()) {
            const double share = total > 0 ? luminance(light->power()) / total : 0;
            end_.push_back((end_.empty() ? 0 : end_.back()) +
                           std::max<std::uint64_t>(1, static_cast<std::uint64_t>(share * paths)));
        }
        for (std::size_t m = 0; m < world.materials().size(); ++m)
            if (const Medium* medium = world.materials()[m].shader->interior(); medium && !is_black(medium->absorption))
                absorbing_.push_back(static_cast<std::uint32_t>(m));
    }

    EnergyLedger run() {
        std::vector<Books> all(pieces);
        parallel_for(pieces, [&](std::int64_t piece) {
            Books& books = all[static_cast<std::size_t>(piece)];
            books.materials.resize(world_.materials().size());
            const auto first = [&](std::int64_t i) { return path_count() * static_cast<std::uint64_t>(i) / pieces; };
            for (std::uint64_t i = first(piece); i < first(piece + 1); ++i) {
                follow(i, books);
                books.end_path();
            }
        });
        return closed(all);
    }

private:
    [[nodiscard]] std::uint64_t path_count() const { return end_.empty() ? 0 : end_.back(); }
    void follow(std::uint64_t path, Books& books) const noexcept;
    [[nodiscard]] Rgb through_medium(const Medium* medium, double length, Rgb flux, Books& books) const noexcept;
    [[nodiscard]] std::uint32_t owner(const Medium* medium) const noexcept;
    [[nodiscard]] EnergyLedger closed(const std::vector<Books>& all) const;

    const World& world_;
    std::uint32_t seed_;
    std::vector<std::uint64_t> end_;        ///< past the last path of each light
    std::vector<std::uint32_t> absorbing_;  ///< materials whose inside absorbs
};

std::uint32_t Audit::owner(const Medium* medium) const noexcept {
    for (const std::uint32_t m : absorbing_)
        if (world_.materials()[m].shader->interior() == medium) return m;
    return 0;
}

Rgb Audit::through_medium(const Medium* medium, double length, Rgb flux, Books& books) const noexcept {
    if (!medium || is_black(medium->absorption)) return flux;
    // Infinity times no absorption would be NaN.
    const Rgb left = flux * exp(medium->absorption * -static_cast<float>(std::min(length, 1e30)));
    books.absorb(owner(medium), flux_of(flux) - flux_of(left));
    return left;
}

/// Share of the flux that goes on into the direction drawn: a Bsdf's weight is for radiance.
Rgb flux_weight(const SurfacePoint& point, Vec3 wo_local, const BsdfSample& s) {
    if ((s.wi.z > 0) == (wo_local.z > 0)) return s.weight;
    const Medium *from = point.front, *to = point.back;
    if (wo_local.z < 0) std::swap(from, to);
    return s.weight * (to->ior * to->ior / (from->ior * from->ior));
}

void Audit::follow(std::uint64_t path, Books& books) const noexcept {
    const auto light = static_cast<std::size_t>(std::upper_bound(end_.begin(), end_.end(), path) - end_.begin());
    const std::uint64_t begin = light == 0 ? 0 : end_[light - 1];
    Sampler sampler(seed_, Purpose::ledger, light, static_cast<std::uint32_t>(path - begin));
    const Vec2 place = sampler.next2();
    const LightEmission photon = world_.lights()[light]->emit(place, sampler.next2());
    Rgb flux = photon.flux * (1 / static_cast<float>(end_[light] - begin));
    if (is_bad(flux)) {
        ++books.bad;
        return;
    }
    books.emitted += flux_of(flux);
    const float whole = max_component(flux);
    Ray ray = photon.ray;
    const Medium* medium = nullptr;
    for (int step = 0; !is_black(flux); ++step) {
        const Hit hit = world_.intersect(ray);
        // Halfway to the first surface there is no doubt which side of a face the lamp is on.
        if (step == 0 && !absorbing_.empty() && hit.found()) medium = world_.medium_at(ray.o + ray.d * (hit.t / 2));
        flux = through_medium(medium, hit.t, flux, books);
        if (!hit.found()) {
            books.escaped += flux_of(flux);
            return;
        }
        const SurfacePoint point = world_.surface(ray, hit);
        books.materials[point.material].received += flux_of(flux);
        BsdfMemory memory;
        const Vec3 wo = point.frame.to_local(Vec3(-ray.d));
        const float u_lobe = sampler.next();
        const BsdfSample s = world_.bsdf(point, memory)->sample(wo, u_lobe, sampler.next2());
        const Rgb left = is_black(s.weight) ? Rgb{} : flux * flux_weight(point, wo, s);
        if (is_bad(left)) {
            ++books.bad;
            books.cut_off += flux_of(flux);
            return;
        }
        books.absorb(point.material, flux_of(flux) - flux_of(left));
        const float share = max_component(left) / whole;
        const float chance = std::min(share / sure_share, best_chance(step));
        const bool lives = step < most_steps && sampler.next() < chance;
        flux = lives ? left * (1 / chance) : Rgb{};
        books.cut_off += flux_of(left) - flux_of(flux);
        const Vec3 wi = point.frame.to_world(s.wi);
        medium = dot(point.ng, wi) > 0 ? point.front : point.back;
        const Vec3d straight = ray.d;
        ray = point.ray(wi);
        // What is not bent is not turned by rounding either.
        if (s.wi == -wo) ray.d = straight;
    }
}

EnergyLedger Audit::closed(const std::vector<Books>& all) const {
    EnergyLedger ledger;
    ledger.paths = path_count();
    for (const auto& light : world_.lights()) ledger.power += flux_of(light->power());
    std::vector<MaterialFlux> materials(world_.materials().size());
    std::vector<double> squares(materials.size());
    for (const Books& books : all) {
        ledger.emitted += books.emitted;
        ledger.escaped += books.escaped;
        ledger.cut_off += books.cut_off;
        ledger.bad_paths += books.bad;
        for (std::size_t m = 0; m < materials.size(); ++m) {
            materials[m].received += books.materials[m].received;
            materials[m].absorbed += books.materials[m].absorbed;
            squares[m] += books.materials[m].squares;
        }
    }
    for (std::size_t m = 0; m < materials.size(); ++m) {
        if (materials[m].received.sum() == 0 && materials[m].absorbed.sum() == 0) continue;
        materials[m].material = world_.materials()[m].name;
        materials[m].error = std::sqrt(squares[m]);
        ledger.absorbed.push_back(std::move(materials[m]));
    }
    return ledger;
}

}  // namespace

Flux EnergyLedger::absorbed_in_all() const {
    Flux sum;
    for (const MaterialFlux& m : absorbed) sum += m.absorbed;
    return sum;
}

double EnergyLedger::imbalance() const {
    const Flux rest = emitted - absorbed_in_all() - escaped - cut_off;
    double worst = 0;
    for (std::size_t c = 0; c < 3; ++c)
        if (emitted.channel[c] > 0) worst = std::max(worst, std::abs(rest.channel[c]) / emitted.channel[c]);
    return worst;
}

EnergyLedger energy_ledger(const World& world, std::uint32_t seed, std::uint32_t paths) {
    return Audit(world, seed, paths).run();
}

std::vector<std::string> ledger_warnings(const EnergyLedger& ledger) {
    std::vector<std::string> all;
    for (const MaterialFlux& m : ledger.absorbed) {
        const double gain = -m.absorbed.sum(), received = m.received.sum();
        if (gain > beyond_doubt * m.error && gain > worth_telling * received)
            all.push_back(fmt::format("material \"{}\" gives out {:.3g} % more light than it gets", m.material,
                                      100 * gain / received));
    }
    if (std::abs(ledger.emitted.sum() - ledger.power.sum()) > power_tolerance * ledger.power.sum())
        all.push_back(fmt::format("the lights say that they give {:.4g} W, but emit {:.4g} W", ledger.power.sum(),
                                  ledger.emitted.sum()));
    if (ledger.bad_paths > 0)
        all.push_back(fmt::format("{} of {} light paths had a flux that was not finite or negative", ledger.bad_paths,
                                  ledger.paths));
    return all;
}

}  // namespace cardioid
