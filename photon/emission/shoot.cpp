#include "photon/emission/shoot.hpp"

#include <algorithm>
#include <atomic>

#include "photon/emission/batches.hpp"
#include "photon/propagation/breadth.hpp"
#include "rt_core/api/parallel.hpp"

namespace cardioid::photon {

namespace {

/// Photons of a chunk. Results do not depend on it but for the grouping of the ledger's sums.
constexpr std::uint64_t chunk_size = 1 << 12;

struct Chunk {
    std::vector<Photon> photons;
    Ledger ledger;
};

/// A photon's mean flux: that of a white light is encoded without an error, which all photons would share.
float flux_scale(Rgb power, std::uint64_t count) {
    const double mean = double{max_component(power)} / static_cast<double>(std::max<std::uint64_t>(count, 1));
    constexpr double least = 1e-30, most = 1e30;  // where floats and their inverse have all their digits
    return mean > 0 && std::isfinite(mean) ? static_cast<float>(std::clamp(mean, least, most)) : 1;
}

/// Emits the photons [first, last) of the list.
void run_chunk(const World& world, const PhotonOptions& options, const ShotRequest& request, const BatchList& list,
               std::uint64_t first, std::uint64_t last, PhotonPath& path) {
    const auto after = std::upper_bound(list.batches.begin(), list.batches.end(), first,
                                        [](std::uint64_t i, const Batch& batch) { return i < batch.first; });
    auto batch = after - 1;
    PhotonStream numbers(request.seed, request.pass);
    for (std::uint64_t i = first; i < last; ++i) {
        if (i >= batch->first + batch->count) ++batch;
        Sampler sampler = numbers.sampler(batch->cell.light, batch->stratum,
                                          static_cast<std::uint32_t>(i - batch->first), batch->count);
        const EmissionNumbers u = batch->cell.inside(draw_emission(options.directions, sampler));
        const Light& light = *world.lights()[batch->cell.light];
        const LightEmission emission = light.emit(u.place, u.direction);
        path.follow(light, emission.ray, emission.flux * batch->share, sampler);
    }
}

/// Chunk after chunk in one list; each is given back as soon as it is copied, so that little is held twice.
void concatenate(std::vector<Chunk>& chunks, Shot& shot) {
    std::vector<std::size_t> first;
    std::size_t count = 0;
    for (const Chunk& chunk : chunks) {
        first.push_back(count);
        count += chunk.photons.size();
        shot.ledger += chunk.ledger;
    }
    shot.photons.resize(count);
    parallel_for(static_cast<std::int64_t>(chunks.size()), [&](std::int64_t c) {
        const auto i = static_cast<std::size_t>(c);
        std::ranges::copy(chunks[i].photons, shot.photons.begin() + static_cast<std::ptrdiff_t>(first[i]));
        std::vector<Photon>().swap(chunks[i].photons);
    });
}

}  // namespace

Shot shoot(const World& world, const PhotonOptions& options, const ShotRequest& request, Progress& progress) {
    const BatchList list = request.aim && !request.aim->cells.empty()
                               ? aimed_batches(world.lights(), request.count, *request.aim)
                               : even_batches(world.lights(), request.count, options.shares);
    Shot shot;
    shot.power = total_power(world.lights());
    shot.emitted = list.total;
    shot.origin = world.bounds().empty() ? Vec3d{} : world.bounds().centre();
    shot.flux_scale = flux_scale(shot.power, list.total);

    const float least = least_breadth(world);
    std::vector<Chunk> chunks((list.total + chunk_size - 1) / chunk_size);
    std::atomic<std::uint64_t> done{0};
    parallel_for(static_cast<std::int64_t>(chunks.size()), [&](std::int64_t c) {
        if (progress.interrupted()) return;
        const std::uint64_t first = static_cast<std::uint64_t>(c) * chunk_size;
        PhotonPath path(world, {options.roulette, options.rr_double_count},
                        {request.keep, request.unwanted, options.mode == Mode::physical, options.store, shot.origin,
                         shot.flux_scale, least});
        // Memory that is not written to costs nothing; growing would.
        path.photons.reserve(4 * chunk_size);
        run_chunk(world, options, request, list, first, std::min(first + chunk_size, list.total), path);
        Chunk& chunk = chunks[static_cast<std::size_t>(c)];
        chunk.photons = std::move(path.photons);
        chunk.ledger = path.ledger;
        progress.update(static_cast<double>(++done) / static_cast<double>(chunks.size()));
    });
    concatenate(chunks, shot);
    return shot;
}

}  // namespace cardioid::photon
