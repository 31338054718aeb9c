/* A plug-in with one fault, chosen by FAULT_...; without any it would be in order. Its attach and its name must not be
 * touched where the ABI is another, so both end the program then. */
#include <stdlib.h>

#include "rt_core/api/plugin.h"

#ifndef FAULT_MAJOR
#define FAULT_MAJOR CARDIOID_ABI_MAJOR
#endif
#ifndef FAULT_MINOR
#define FAULT_MINOR CARDIOID_ABI_MINOR
#endif
#ifndef FAULT_SIZE
#define FAULT_SIZE sizeof(CardioidPlugin)
#endif
#ifndef FAULT_ATTACH
#define FAULT_ATTACH must_not_be_called
#endif

int must_not_be_called(const CardioidHost* host);
int must_not_be_called(const CardioidHost* host) {
    (void)host;
    abort();
}

int refuse(const CardioidHost* host);
int refuse(const CardioidHost* host) {
    host->log("the moon is not full");
    return CARDIOID_FAILED;
}

#ifndef FAULT_NO_QUERY
const CardioidPlugin* cardioid_plugin_query(void) {
    static const CardioidPlugin plugin = {FAULT_SIZE, FAULT_MAJOR, FAULT_MINOR, "faulty", "0.1", FAULT_ATTACH};
#ifdef FAULT_NOTHING
    (void)plugin;
    return 0;
#else
    return &plugin;
#endif
}
#endif
