#pragma once
#include <cstddef>
#include <cstdint>

namespace cardioid::photon {

/// The report's own rule (ARL-TR-3608, note [1]): 10,000 photons and one more for every 100 triangles.
[[nodiscard]] constexpr std::uint64_t report_count(std::size_t faces) { return 10'000 + faces / 100; }

/// Photons of a lookup whose relative standard error is `error` in (0, 1]: k photons, of which the last only sets the
/// radius, scatter by 1/sqrt(k - 2).
[[nodiscard]] std::uint32_t lookup_size(double error);

/// Photons to emit so that a disc of `radius` holds k of them where one emitted photon leaves `density` photons per
/// square scene unit; 0 where nothing arrives.
[[nodiscard]] double count_for(double k, double radius, double density);

/// Bytes that a pass and the map built from it take at their largest: the photons as they come, and their tree.
[[nodiscard]] double bytes_of(double stored);

/// Bytes that photons may take where nobody says: half of what the machine has.
[[nodiscard]] double default_memory();

}  // namespace cardioid::photon
