#pragma once
#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace cardioid::photon {

/// An allocator that leaves new elements of a vector as they are, so that large arrays are first touched, and their
/// pages made, by the threads that fill them. Elements that are no more than their bytes need no constructor to be
/// assigned to.
template <class T>
struct UntouchedAllocator : std::allocator<T> {
    template <class U>
    struct rebind {
        using other = UntouchedAllocator<U>;
    };
    UntouchedAllocator() = default;
    template <class U>
    UntouchedAllocator(const UntouchedAllocator<U>& /*other*/) noexcept {}

    template <class U>
    void construct(U* /*place*/) noexcept {
        static_assert(std::is_trivially_copyable_v<U> && std::is_trivially_destructible_v<U>);
    }
    template <class U, class... Args>
    void construct(U* place, Args&&... args) {
        ::new (static_cast<void*>(place)) U(std::forward<Args>(args)...);
    }
};

/// resize() leaves new elements without a value.
template <class T>
using UntouchedVector = std::vector<T, UntouchedAllocator<T>>;

}  // namespace cardioid::photon
