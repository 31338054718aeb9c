#pragma once
#include <atomic>
#include <cstdint>
#include <exception>

namespace cardioid {

/// Runs body(i) for i in [0, n) on all threads; the first exception stops the rest and is thrown again here.
template <class Body>
void parallel_for(std::int64_t n, Body&& body) {
    std::exception_ptr first;
    std::atomic<bool> stop{false};
#pragma omp parallel for schedule(dynamic, 1)
    for (std::int64_t i = 0; i < n; ++i) {
        if (stop.load(std::memory_order_relaxed)) continue;
        try {
            body(i);
        } catch (...) {
            if (!stop.exchange(true)) first = std::current_exception();
        }
    }
    if (first) std::rethrow_exception(first);
}

}  // namespace cardioid
