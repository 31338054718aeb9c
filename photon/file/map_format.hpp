#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace cardioid::photon {

/// Layout of a map file: a FileHeader, then sections, each a SectionHeader, its items as they lie in memory, and a
/// checksum of both (8 bytes); the last section is named "end" and has no items. Numbers are those of the machine that
/// wrote it; another kind of machine refuses the file.
inline constexpr std::array<char, 8> file_magic{'C', 'A', 'R', 'D', 'M', 'A', 'P', '\n'};
/// One more whenever a file of before would be misread. Version 1 had in LookupSizes::caustic_radius the largest disc
/// of a lookup; since 2 it is how far photons of the caustic map reach. Version 3 has Photon::breadth,
/// 4 Way::broad.
inline constexpr std::uint32_t file_version = 4;
inline constexpr std::uint32_t byte_order = 0x01020304;
inline constexpr const char* end_section = "end";

struct FileHeader {
    std::array<char, 8> magic = file_magic;
    std::uint32_t version = file_version, order = byte_order;
    std::uint64_t scene = 0;     ///< World::hash()
    std::uint64_t checksum = 0;  ///< of the fields before
};
static_assert(sizeof(FileHeader) == 32);

struct SectionHeader {
    std::array<char, 24> name{};  ///< ends with 0
    std::uint64_t item_bytes = 0, count = 0;
};
static_assert(sizeof(SectionHeader) == 40);

/// Notices any changed byte and any swap; no protection against intent.
class Checksum {
public:
    /// A run of bytes at once.
    void add(std::span<const std::byte> bytes) { begin(bytes.size()), add_words(bytes); }
    /// The same piece by piece: its length, then its bytes; all pieces but the last are multiples of 8 bytes.
    void begin(std::uint64_t length);
    void add_words(std::span<const std::byte> bytes);
    [[nodiscard]] std::uint64_t value() const { return sum_; }

private:
    std::uint64_t sum_ = 0x5EED;
};

}  // namespace cardioid::photon
