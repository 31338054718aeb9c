/// The same module as a shared object for --plugin: that the hooks are enough for it. It comes under a name of its own,
/// for the program has `photon` already.
#include <exception>

#include "photon/lighting/photon_lighting.hpp"
#include "rt_core/api/plugin.h"
#include "rt_core/api/registry.hpp"

namespace {

/// Nothing may be thrown through the C interface; what went wrong is logged.
int attach(const CardioidHost* host) {
    try {
        cardioid::LightingKind kind = cardioid::photon::photon_lighting;
        kind.name = "photon_plugin";
        host->registry->add(kind);
        return CARDIOID_OK;
    } catch (const std::exception& error) {
        host->log(error.what());
        return CARDIOID_FAILED;
    }
}

constexpr CardioidPlugin plugin{sizeof(CardioidPlugin), CARDIOID_ABI_MAJOR, CARDIOID_ABI_MINOR,
                                "photon_plugin",        CARDIOID_VERSION,   attach};

}  // namespace

extern "C" const CardioidPlugin* cardioid_plugin_query() { return &plugin; }
