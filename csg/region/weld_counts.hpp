#pragma once
#include <atomic>
#include <cstdint>

namespace cardioid::csg {

/// How often rays have met faces that coincide, and nothing was left between them.
struct WeldCounts {
    std::uint64_t exact = 0;   ///< at one distance along the ray
    std::uint64_t welded = 0;  ///< a little apart, within the weld tolerance
};

/// Of all rays of the process so far. Any thread may call it; counts of rays under way may be missing.
WeldCounts weld_counts() noexcept;

/// The counts of one thread: make one a thread, and it takes part in weld_counts() for good.
class ThreadWeldCounts {
public:
    ThreadWeldCounts();
    ~ThreadWeldCounts();
    ThreadWeldCounts(const ThreadWeldCounts&) = delete;
    ThreadWeldCounts& operator=(const ThreadWeldCounts&) = delete;

    // Only the thread itself writes, so no locked addition is needed.
    void add_exact() noexcept { add(exact_); }
    void add_welded() noexcept { add(welded_); }
    [[nodiscard]] WeldCounts counts() const noexcept;

private:
    static void add(std::atomic<std::uint64_t>& count) noexcept {
        count.store(count.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
    }
    std::atomic<std::uint64_t> exact_{0}, welded_{0};
};

}  // namespace cardioid::csg
