#include "photon/emission/aim.hpp"

#include <algorithm>
#include <numeric>

#include "photon/emission/batches.hpp"
#include "photon/propagation/photon_path.hpp"
#include "rt_core/api/parallel.hpp"

namespace cardioid::photon {

namespace {

/// Tries below which a cell is divided no further.
constexpr std::size_t fewest_tries = 64;
constexpr std::uint64_t chunk_size = 1 << 12;
/// Densities where nothing was seen: beside a cell that makes caustics, whose border may lie a little within, and
/// elsewhere. They bound the flux of a photon that makes a caustic all the same.
constexpr double density_beside = 1.0 / 8, density_elsewhere = 1.0 / 32;

using Numbers = std::array<float, 4>;

/// A photon that was tried.
struct Try {
    Numbers u;
    bool hit;  ///< it made a caustic
};

/// Whether each of a light's numbers changes its rays at all: a point has no place to choose.
std::array<bool, 4> used_numbers(const Light& light) {
    constexpr float base[] = {0.37F, 0.61F, 0.23F, 0.83F}, other[] = {0.71F, 0.19F, 0.59F, 0.31F};
    const auto emit = [&](int changed) {
        Numbers u;
        for (int i = 0; i < 4; ++i) u[static_cast<std::size_t>(i)] = i == changed ? other[i] : base[i];
        return light.emit({u[0], u[1]}, {u[2], u[3]});
    };
    const LightEmission first = emit(-1);
    std::array<bool, 4> used{};
    for (int i = 0; i < 4; ++i) {
        const LightEmission e = emit(i);
        used[static_cast<std::size_t>(i)] =
            !(e.ray.o == first.ray.o) || !(e.ray.d == first.ray.d) || !(e.flux == first.flux);
    }
    return used;
}

std::size_t hits(std::span<const Try> tries) {
    return static_cast<std::size_t>(std::count_if(tries.begin(), tries.end(), [](const Try& t) { return t.hit; }));
}

double root_of_share(double hit, double n) { return n > 0 ? std::sqrt(hit / n) : 0; }

/// Divides a light's emission into cells by its tries.
class Divider {
public:
    Divider(std::uint32_t light, std::array<bool, 4> used, std::vector<AimCell>& cells)
        : light_(light), used_(used), cells_(cells) {}

    void divide(AimCell cell, std::span<Try> tries) {
        cell.light = light_;
        const std::size_t hit = hits(tries);
        const int axis = hit == 0 || hit == tries.size() || tries.size() < fewest_tries ? -1 : best_axis(cell, tries);
        if (axis < 0) {
            cell.density = root_of_share(static_cast<double>(hit), static_cast<double>(tries.size()));
            cells_.push_back(cell);
            return;
        }
        const auto a = static_cast<std::size_t>(axis);
        cell.size[a] /= 2;
        AimCell upper = cell;
        upper.lo[a] += cell.size[a];
        const auto middle =
            std::stable_partition(tries.begin(), tries.end(), [&](const Try& t) { return t.u[a] < upper.lo[a]; });
        const auto below = static_cast<std::size_t>(middle - tries.begin());
        divide(cell, tries.first(below));
        divide(upper, tries.subspan(below));
    }

private:
    /// The axis along whose slices caustic-making and other tries are told apart best: the least sum of roots.
    [[nodiscard]] int best_axis(const AimCell& cell, std::span<const Try> tries) const {
        constexpr std::size_t slices = 8;
        int best = -1;
        double least = HUGE_VAL;
        for (std::size_t a = 0; a < 4; ++a) {
            if (!used_[a]) continue;
            std::array<double, slices> n{}, hit{};
            for (const Try& t : tries) {
                const float along = (t.u[a] - cell.lo[a]) / cell.size[a] * slices;
                const std::size_t i = std::min(static_cast<std::size_t>(std::max(along, 0.0F)), slices - 1);
                n[i] += 1, hit[i] += t.hit ? 1 : 0;
            }
            double sum = 0;
            for (std::size_t i = 0; i < slices; ++i) sum += root_of_share(hit[i], n[i]);
            if (sum < least) least = sum, best = static_cast<int>(a);
        }
        return best;
    }

    std::uint32_t light_;
    std::array<bool, 4> used_;
    std::vector<AimCell>& cells_;
};

/// Whether two cells touch or overlap in every number; 0 and 1 are neighbours, for angles go round.
bool touch(const AimCell& a, const AimCell& b) {
    for (std::size_t i = 0; i < 4; ++i) {
        const float a1 = a.lo[i] + a.size[i], b1 = b.lo[i] + b.size[i];
        const bool here = a.lo[i] <= b1 && b.lo[i] <= a1;
        const bool round = (a.lo[i] == 0 && b1 == 1) || (b.lo[i] == 0 && a1 == 1);
        if (!here && !round) return false;
    }
    return true;
}

/// Gives every cell of a light a density above 0.
void fill_gaps(std::span<AimCell> cells) {
    std::vector<std::size_t> seen;
    for (std::size_t i = 0; i < cells.size(); ++i)
        if (cells[i].density > 0) seen.push_back(i);
    for (AimCell& cell : cells) {
        const bool beside = std::any_of(seen.begin(), seen.end(), [&](std::size_t i) { return touch(cell, cells[i]); });
        cell.density = std::max(cell.density, beside ? density_beside : density_elsewhere);
    }
}

/// Follows the photons of a list by mirrors and glass and tells which made caustics.
std::vector<Try> try_out(const World& world, const PhotonOptions& options, std::uint32_t seed, const BatchList& list,
                         Progress& progress) {
    std::vector<Try> tries(list.total);
    const std::uint64_t chunks = (list.total + chunk_size - 1) / chunk_size;
    parallel_for(static_cast<std::int64_t>(chunks), [&](std::int64_t c) {
        if (progress.interrupted()) return;
        PhotonPath path(world, {options.roulette, false},
                        {.keep = Keep::caustics, .broad_apart = options.mode == Mode::physical});
        PhotonStream numbers(seed, Pass::aim);
        const std::uint64_t first = static_cast<std::uint64_t>(c) * chunk_size;
        auto batch = std::upper_bound(list.batches.begin(), list.batches.end(), first,
                                      [](std::uint64_t i, const Batch& b) { return i < b.first; }) -
                     1;
        for (std::uint64_t i = first; i < std::min(first + chunk_size, list.total); ++i) {
            if (i >= batch->first + batch->count) ++batch;
            Sampler sampler =
                numbers.sampler(batch->cell.light, 0, static_cast<std::uint32_t>(i - batch->first), batch->count);
            const EmissionNumbers u = draw_emission(Directions::closed, sampler);
            const Light& light = *world.lights()[batch->cell.light];
            const LightEmission emission = light.emit(u.place, u.direction);
            const std::uint64_t before = path.ledger.caustic_paths;
            path.follow(light, emission.ray, emission.flux, sampler);
            path.photons.clear();
            tries[i] = {{u.place.x, u.place.y, u.direction.x, u.direction.y}, path.ledger.caustic_paths > before};
        }
    });
    return tries;
}

}  // namespace

EmissionNumbers AimCell::inside(const EmissionNumbers& u) const noexcept {
    // Rounding must not reach 1.
    const auto at = [&](std::size_t i, float x) { return std::min(lo[i] + x * size[i], 0x1.fffffep-1F); };
    return {{at(0, u.place.x), at(1, u.place.y)}, {at(2, u.direction.x), at(3, u.direction.y)}};
}

Aim find_aim(const World& world, const PhotonOptions& options, std::uint32_t seed, std::uint64_t paths,
             Progress& progress) {
    const BatchList list = even_batches(world.lights(), paths, Shares::power);
    std::vector<Try> tries = try_out(world, options, seed, list, progress);
    Aim aim;
    aim.paths = list.total;
    aim.share = list.total == 0 ? 0 : static_cast<double>(hits(tries)) / static_cast<double>(list.total);
    for (const Batch& batch : list.batches) {
        const std::size_t before = aim.cells.size();
        const std::span<Try> own = std::span(tries).subspan(batch.first, batch.count);
        Divider(batch.cell.light, used_numbers(*world.lights()[batch.cell.light]), aim.cells).divide(batch.cell, own);
        fill_gaps(std::span(aim.cells).subspan(before));
    }
    return aim;
}

}  // namespace cardioid::photon
