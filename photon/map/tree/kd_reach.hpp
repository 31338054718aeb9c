#pragma once
#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

namespace cardioid::photon {

/// How far the points below each node of a KdTree reach: those of a bucket equally far, and a split as far as the
/// farther of its sides. 2 bytes a node: the upper half of a float.
class KdReach {
public:
    explicit KdReach(std::size_t nodes = 0) : halves_(nodes) {}
    /// Rounds down, by less than 1/128; finite, >= 0.
    void set(std::size_t node, float reach) noexcept {
        halves_[node] = static_cast<std::uint16_t>(std::bit_cast<std::uint32_t>(reach) >> 16);
    }
    [[nodiscard]] float operator[](std::size_t node) const noexcept {
        return std::bit_cast<float>(std::uint32_t{halves_[node]} << 16);
    }
    [[nodiscard]] bool empty() const noexcept { return halves_.empty(); }
    [[nodiscard]] std::size_t memory_bytes() const noexcept { return halves_.capacity() * sizeof(std::uint16_t); }

private:
    std::vector<std::uint16_t> halves_;
};

}  // namespace cardioid::photon
