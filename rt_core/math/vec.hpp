#pragma once
#include <algorithm>
#include <cmath>

namespace cardioid {

template <class T>
struct Vec2T {
    T x{}, y{};
    constexpr Vec2T() = default;
    constexpr Vec2T(T x_, T y_) : x(x_), y(y_) {}
    template <class U>
    constexpr explicit Vec2T(Vec2T<U> v) : x(static_cast<T>(v.x)), y(static_cast<T>(v.y)) {}
    constexpr bool operator==(const Vec2T&) const = default;
};

template <class T>
constexpr Vec2T<T> operator+(Vec2T<T> a, Vec2T<T> b) {
    return {a.x + b.x, a.y + b.y};
}
template <class T>
constexpr Vec2T<T> operator-(Vec2T<T> a, Vec2T<T> b) {
    return {a.x - b.x, a.y - b.y};
}
template <class T>
constexpr Vec2T<T> operator*(Vec2T<T> a, T s) {
    return {a.x * s, a.y * s};
}
template <class T>
constexpr T dot(Vec2T<T> a, Vec2T<T> b) {
    return a.x * b.x + a.y * b.y;
}
/// The z component of the cross product: twice the signed area of the triangle (0, a, b).
template <class T>
constexpr T cross(Vec2T<T> a, Vec2T<T> b) {
    return a.x * b.y - a.y * b.x;
}

template <class T>
struct Vec3T {
    T x{}, y{}, z{};
    constexpr Vec3T() = default;
    constexpr Vec3T(T x_, T y_, T z_) : x(x_), y(y_), z(z_) {}
    template <class U>
    constexpr explicit Vec3T(Vec3T<U> v) : x(static_cast<T>(v.x)), y(static_cast<T>(v.y)), z(static_cast<T>(v.z)) {}
    constexpr bool operator==(const Vec3T&) const = default;
    constexpr T operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
    constexpr T& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }
    constexpr Vec3T operator-() const { return {-x, -y, -z}; }
    constexpr Vec3T& operator+=(Vec3T v) { return *this = *this + v; }
    constexpr Vec3T& operator-=(Vec3T v) { return *this = *this - v; }
    constexpr Vec3T& operator*=(T s) { return *this = *this * s; }
    friend constexpr Vec3T operator+(Vec3T a, Vec3T b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend constexpr Vec3T operator-(Vec3T a, Vec3T b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend constexpr Vec3T operator*(Vec3T a, T s) { return {a.x * s, a.y * s, a.z * s}; }
    friend constexpr Vec3T operator*(T s, Vec3T a) { return a * s; }
    friend constexpr Vec3T operator/(Vec3T a, T s) { return {a.x / s, a.y / s, a.z / s}; }
};

template <class T>
constexpr T dot(Vec3T<T> a, Vec3T<T> b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
constexpr Vec3T<T> cross(Vec3T<T> a, Vec3T<T> b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class T>
T length(Vec3T<T> v) {
    return std::sqrt(dot(v, v));
}
template <class T>
T length(Vec2T<T> v) {
    return std::sqrt(dot(v, v));
}
/// v scaled to length 1; v must not be zero.
template <class T>
Vec3T<T> normalize(Vec3T<T> v) {
    return v * (T(1) / length(v));
}
template <class T>
Vec3T<T> min(Vec3T<T> a, Vec3T<T> b) {
    return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}
template <class T>
Vec3T<T> max(Vec3T<T> a, Vec3T<T> b) {
    return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}
template <class T>
Vec3T<T> abs(Vec3T<T> v) {
    return {std::abs(v.x), std::abs(v.y), std::abs(v.z)};
}
template <class T>
T max_component(Vec3T<T> v) {
    return std::max(v.x, std::max(v.y, v.z));
}
template <class T>
bool is_finite(Vec3T<T> v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

using Vec2 = Vec2T<float>;
using Vec2d = Vec2T<double>;
using Vec3 = Vec3T<float>;
using Vec3d = Vec3T<double>;

}  // namespace cardioid
