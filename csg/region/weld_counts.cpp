#include "csg/region/weld_counts.hpp"

#include <algorithm>
#include <mutex>
#include <vector>

namespace cardioid::csg {
namespace {

/// Threads that live, and what those that have ended left.
struct AllThreads {
    std::mutex mutex;
    std::vector<const ThreadWeldCounts*> live;
    WeldCounts ended;
};

/// Never destroyed: threads may end after main().
AllThreads& all_threads() {
    static AllThreads* const all = new AllThreads;
    return *all;
}

void include(WeldCounts& to, const WeldCounts& counts) { to.exact += counts.exact, to.welded += counts.welded; }

}  // namespace

ThreadWeldCounts::ThreadWeldCounts() {
    AllThreads& all = all_threads();
    const std::lock_guard lock(all.mutex);
    all.live.push_back(this);
}

ThreadWeldCounts::~ThreadWeldCounts() {
    AllThreads& all = all_threads();
    const std::lock_guard lock(all.mutex);
    std::erase(all.live, this);
    include(all.ended, counts());
}

WeldCounts ThreadWeldCounts::counts() const noexcept {
    return {exact_.load(std::memory_order_relaxed), welded_.load(std::memory_order_relaxed)};
}

WeldCounts weld_counts() noexcept {
    AllThreads& all = all_threads();
    const std::lock_guard lock(all.mutex);
    WeldCounts sum = all.ended;
    for (const ThreadWeldCounts* const thread : all.live) include(sum, thread->counts());
    return sum;
}

}  // namespace cardioid::csg
