#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <dlfcn.h>
#include <filesystem>
#include <fmt/format.h>
#include <system_error>

#include "rt_core/api/plugin.h"
#include "rt_core/plugin/registry.hpp"

namespace cardioid {
namespace {

namespace fs = std::filesystem;

/// What the plug-in being attached has logged: the reason, should it refuse. The C interface has no room for a context.
thread_local std::string attach_log;

void remember(const char* text) {
    if (!text) return;
    if (!attach_log.empty()) attach_log += "; ";
    attach_log += text;
}

[[noreturn]] void refuse(const std::string& path, const std::string& why, ErrorCode code = ErrorCode::usage) {
    throw Error(code, fmt::format("{}: {}", path, why));
}

/// A path that dlopen does not search for, of a file that is there.
void check_path(const std::string& path) {
    if (path.find('/') == std::string::npos)
        refuse(path, fmt::format("a plug-in is named by a path with a slash; write ./{}", path));
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status)) refuse(path, "no such plug-in file", ErrorCode::io);
    if (fs::is_directory(status)) refuse(path, "is a folder, not a plug-in", ErrorCode::io);
}

using Query = const CardioidPlugin* (*)();

/// Loads the object for good and finds its one exported function.
Query open_object(const std::string& path) {
    void* const object = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!object) {
        const char* const reason = dlerror();
        refuse(path, fmt::format("cannot be loaded: {}", reason ? reason : "no reason given"), ErrorCode::io);
    }
    const auto query = reinterpret_cast<Query>(dlsym(object, "cardioid_plugin_query"));
    if (!query) refuse(path, "is not a Cardioid plug-in: it does not export cardioid_plugin_query");
    return query;
}

/// Reads nothing of the plug-in but its first three fields, whose place no version changes.
void check_abi(const std::string& path, const CardioidPlugin& plugin) {
    if (plugin.abi_major != CARDIOID_ABI_MAJOR || plugin.abi_minor > CARDIOID_ABI_MINOR)
        refuse(path, fmt::format("was built for plug-in ABI {}.{}, this program has {}.{}; build it anew",
                                 plugin.abi_major, plugin.abi_minor, CARDIOID_ABI_MAJOR, CARDIOID_ABI_MINOR));
    if (plugin.size < offsetof(CardioidPlugin, attach) + sizeof plugin.attach)
        refuse(path, fmt::format("describes itself in {} bytes, wanted at least {}", plugin.size,
                                 offsetof(CardioidPlugin, attach) + sizeof plugin.attach));
}

/// The status of attach(); one that throws although it must not counts as a refusal too.
int attach(const CardioidPlugin& plugin, const CardioidHost& host) {
    try {
        return plugin.attach(&host);
    } catch (const std::exception& error) {
        remember(error.what());
    } catch (...) {
        remember("unknown exception");
    }
    return CARDIOID_FAILED;
}

}  // namespace

void load_plugin(const std::string& path, Registry& registry) {
    check_path(path);
    const CardioidPlugin* const plugin = open_object(path)();
    if (!plugin) refuse(path, "its cardioid_plugin_query returned nothing");
    check_abi(path, *plugin);
    if (!plugin->attach) refuse(path, "has no attach function");

    const CardioidHost host{sizeof host, CARDIOID_ABI_MAJOR, CARDIOID_ABI_MINOR, &registry, &remember};
    attach_log.clear();
    const int status = attach(*plugin, host);
    if (status != CARDIOID_OK)
        refuse(path, fmt::format("plug-in \"{}\" {} did not attach: {}", plugin->name ? plugin->name : "",
                                 plugin->version ? plugin->version : "",
                                 attach_log.empty() ? fmt::format("status {}", status) : attach_log));
}

void load_plugin_path(Registry& registry) {
    const char* const variable = std::getenv("CARDIOID_PLUGIN_PATH");
    const std::string folders = variable ? variable : "";
    for (std::size_t begin = 0; begin < folders.size();) {
        const std::size_t end = std::min(folders.find(':', begin), folders.size());
        const std::string folder = folders.substr(begin, end - begin);
        begin = end + 1;
        if (folder.empty()) continue;
        if (folder[0] != '/') refuse("CARDIOID_PLUGIN_PATH", fmt::format("\"{}\" is not an absolute folder", folder));

        std::error_code error;
        std::vector<std::string> files;
        for (fs::directory_iterator it(folder, error), last; !error && it != last; it.increment(error))
            if (it->path().extension() == ".so") files.push_back(it->path().string());
        if (error) refuse("CARDIOID_PLUGIN_PATH", fmt::format("{}: {}", folder, error.message()), ErrorCode::io);
        std::sort(files.begin(), files.end());
        for (const std::string& file : files) load_plugin(file, registry);
    }
}

}  // namespace cardioid
