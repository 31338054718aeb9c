#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "rt_core/scene/triangle_mesh.hpp"

namespace cardioid::csg {

/// What an expensive result depends on, as 128 bits.
class ContentHash {
public:
    void add(std::uint64_t value);
    void add(double value);
    void add(const TriangleMesh& mesh);
    [[nodiscard]] std::string text() const;  ///< 32 hexadecimal digits

private:
    std::uint64_t a_ = 0x9E3779B97F4A7C15U, b_ = 0xC2B2AE3D27D4EB4FU;
};

/// The meshes that `make` makes, or those it made in an earlier run: results that took longer than `worth_keeping_s`
/// are kept in $XDG_CACHE_HOME/cardioid (else ~/.cache/cardioid), up to 256 MB, the least recently used going first.
/// Files appear whole, so that any number of processes may share them; one that is damaged or cannot be written is as
/// if it were not there. CARDIOID_CACHE=0 keeps nothing.
std::vector<TriangleMesh> cached(const ContentHash& key, const std::function<std::vector<TriangleMesh>()>& make,
                                 double worth_keeping_s = 0.5);

}  // namespace cardioid::csg
