#pragma once
#include <bitset>

#include "photon/map/photon.hpp"

namespace cardioid::photon {

/// Which term of ARL-TR-3608's equation 1 a photon belongs to where it is found. Every path from a light L to the eye E
/// is accounted for exactly once. With D a diffuse, B a broad glossy (is_broad()), G any other glossy (finite width)
/// and S a specular scattering, T a straight pass through a thin filter, X = S|G|T, x the point seen (which has
/// non-delta lobes) and s = (S|T)* its way to the eye:
///
///     path              class      who accounts for it
///     L s E                        LightParts::emission: the renderer, following the eye's ray
///     L T* x s E        direct     World::direct: next-event estimation through filters, all non-delta lobes of x
///     L X* x s E        caustic    LightingModule::caustic: the caustic map; X* has an S or a G
///     L (X|B|D)* x s E  indirect   LightingModule::indirect: cache, gather or global map; there is a B or a D
///
/// A final gather for the last row sends rays from x and follows them by X and B. Where one meets a diffuse lobe, it
/// takes *all* photons of the global map there, of whatever class, times that lobe alone; where one meets a broad
/// lobe, World::direct and the caustic map times that lobe, and it goes on; where one meets a light, nothing: the two
/// rows before have it. So every S or G between x and the last D is traced, every D is looked up. In `mode = report`
/// there is no B.
///
/// The global map holds photons of all classes, so that it answers both "everything that falls here" (gather) and, by
/// class, each row alone. Of the row `caustic` the map has all that leaves x by diffuse lobes. What leaves it by glossy
/// ones is divided between photons and rays drawn from these lobes, by shares that add up to 1 (breadth.hpp): with S+
/// at least one S, b(l) the solid angle under which lamp l is seen, b(y) that of the lobe of a glossy place y, and
/// w = traced_share(density of x's lobe, b),
///
///     path            photons      rays (GlossyCaustics)
///     L S+ x          1 - w(b(L))  w(b(L)): the ray meets the lamp
///     L X* G(y) S* x  1 - w(b(y))  w(b(y)) times all that y sends: World::direct there, and both columns for y as x
///
/// The caustic map is shot by itself and holds its one class; caustic photons of the global map are not added to it.
enum class PathClass : std::uint8_t { direct, caustic, indirect };
inline constexpr int path_classes = 3;
using PathClasses = std::bitset<path_classes>;
constexpr PathClasses only(PathClass kind) { return 1ULL << static_cast<int>(kind); }

constexpr PathClass path_class(Way way) {
    if (has(way, Way::diffuse | Way::broad)) return PathClass::indirect;
    return way == Way::direct ? PathClass::direct : PathClass::caustic;
}

}  // namespace cardioid::photon
