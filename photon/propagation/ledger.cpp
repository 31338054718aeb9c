#include "photon/propagation/ledger.hpp"

#include <algorithm>
#include <cmath>

namespace cardioid::photon {

Ledger& Ledger::operator+=(const Ledger& o) {
    emitted += o.emitted;
    absorbed += o.absorbed;
    escaped += o.escaped;
    cut_off += o.cut_off;
    for (std::size_t i = 0; i < stored.size(); ++i) stored[i] += o.stored[i], photons[i] += o.photons[i];
    paths += o.paths;
    rays += o.rays;
    specular_first += o.specular_first;
    caustic_paths += o.caustic_paths;
    cut += o.cut;
    not_finite += o.not_finite;
    return *this;
}

double Ledger::gap() const {
    double largest = 0;
    for (double FluxSum::*c : {&FluxSum::r, &FluxSum::g, &FluxSum::b})
        if (emitted.*c > 0)
            largest = std::max(largest, std::abs(emitted.*c - absorbed.*c - escaped.*c - cut_off.*c) / (emitted.*c));
    return largest;
}

}  // namespace cardioid::photon
