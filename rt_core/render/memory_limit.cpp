#include "rt_core/render/memory_limit.hpp"

#include <fmt/format.h>
#include <fstream>
#include <unistd.h>

#include "rt_core/api/error.hpp"

namespace cardioid {

namespace {

/// What the kernel says it could give without swapping; where it does not say, all memory there is.
double available_bytes() {
    std::ifstream file("/proc/meminfo");
    std::string key;
    double kilobytes = 0;
    while (file >> key >> kilobytes) {
        if (key == "MemAvailable:") return kilobytes * 1024;
        file.ignore(100, '\n');
    }
    return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

}  // namespace

void require_memory(double bytes, const std::string& what) {
    const double available = available_bytes();
    if (bytes <= available) return;
    constexpr double megabyte = 1e6;
    throw Error(ErrorCode::limit, fmt::format("{} needs {:.0f} bytes ({:.0f} MB), the machine has {:.0f} MB free", what,
                                              bytes, bytes / megabyte, available / megabyte));
}

}  // namespace cardioid
