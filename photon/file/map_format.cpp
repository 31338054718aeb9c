#include "photon/file/map_format.hpp"

#include <cstring>

#include "rt_core/api/math.hpp"

namespace cardioid::photon {

void Checksum::begin(std::uint64_t length) { sum_ = mix64(sum_ ^ length); }

void Checksum::add_words(std::span<const std::byte> bytes) {
    while (bytes.size() >= sizeof(std::uint64_t)) {
        std::uint64_t word;
        std::memcpy(&word, bytes.data(), sizeof(word));
        sum_ = mix64(sum_ ^ word);
        bytes = bytes.subspan(sizeof(word));
    }
    if (bytes.empty()) return;
    std::uint64_t rest = 0;
    std::memcpy(&rest, bytes.data(), bytes.size());
    sum_ = mix64(sum_ ^ rest);
}

}  // namespace cardioid::photon
