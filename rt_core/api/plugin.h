/* What a shared object exports to be loaded with --plugin FILE or by CARDIOID_PLUGIN_PATH. */
#ifndef CARDIOID_PLUGIN_H
#define CARDIOID_PLUGIN_H

#include <stdint.h>

#define CARDIOID_ABI_MAJOR 3 /* changes when a hook changes its shape */
#define CARDIOID_ABI_MINOR 0 /* grows when a hook gains something at its end */

#ifdef __cplusplus
namespace cardioid {
class Registry;
}
extern "C" {
typedef cardioid::Registry CardioidRegistry;
#else
typedef struct CardioidRegistry CardioidRegistry;
#endif

/* What attach() returns. */
typedef enum { CARDIOID_OK = 0, CARDIOID_FAILED = 1 } CardioidStatus;

/* The program, as a plug-in sees it. */
typedef struct {
    uint32_t size; /* sizeof of what the program was compiled with */
    uint16_t abi_major, abi_minor;
    CardioidRegistry* registry;
    void (*log)(const char* text); /* a line for the user */
} CardioidHost;

typedef struct {
    uint32_t size;                 /* sizeof of what the plug-in was compiled with: fields past it do not exist */
    uint16_t abi_major, abi_minor; /* major must equal the program's, minor must not exceed it */
    const char *name, *version;
    int (*attach)(const CardioidHost*); /* registers hooks; 0 or a CardioidStatus; must not throw */
} CardioidPlugin;

#if defined(__GNUC__)
#define CARDIOID_EXPORT __attribute__((visibility("default"))) /* also where the rest is compiled hidden */
#else
#define CARDIOID_EXPORT
#endif

/* The one exported function; called before anything else, so it must not depend on the ABI. */
CARDIOID_EXPORT const CardioidPlugin* cardioid_plugin_query(void);

#ifdef __cplusplus
}
#endif
#endif
