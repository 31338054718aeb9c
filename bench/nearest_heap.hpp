#pragma once
#include <algorithm>
#include <cstdint>

namespace cardioid::bench {

/// Adds a squared distance below the largest to the k smallest so far, which become a heap only once there are k.
inline void keep_nearest(float* heap, std::uint32_t& found, std::uint32_t k, float d2) {
    if (found < k) {
        heap[found++] = d2;
        if (found == k) std::make_heap(heap, heap + k);
        return;
    }
    std::pop_heap(heap, heap + k);
    heap[k - 1] = d2;
    std::push_heap(heap, heap + k);
}

}  // namespace cardioid::bench
