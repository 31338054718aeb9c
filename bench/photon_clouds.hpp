#pragma once
#include <string>
#include <vector>

#include "photon/map/photon.hpp"

namespace cardioid::bench {

/// A place to look up.
struct Place {
    Vec3 p, n;
};

struct PhotonCloud {
    std::vector<photon::Photon> photons;
    std::vector<Place> random;  ///< places on the same surfaces, in no order
    std::vector<Place> morton;  ///< the same along Morton's curve
};

/// n photons on the walls of the unit box, evenly.
PhotonCloud wall_cloud(std::size_t n);
/// n photons gathered in a caustic: nephroid-like, 90 % of them within a few thousandths of its cusped line.
PhotonCloud caustic_cloud(std::size_t n);

}  // namespace cardioid::bench
