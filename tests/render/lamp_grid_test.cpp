#include <gtest/gtest.h>

#include "scene_kit.hpp"

namespace cardioid {
namespace {

using test::SceneKit;

constexpr double pi_d = std::numbers::pi;
constexpr int side = 4;
constexpr double radiance = 3;

/// One lamp of `side` x `side` points, turned so that it shines aslant, over nothing.
SceneKit lamp(const std::string& kind, const char* size_name, const std::vector<double>& size, const Affine& to_world) {
    SceneKit kit;
    kit.root(kit.box({-9, -9, -1}, {9, 9, 0}, 0));
    kit.light(kind, {{size_name, size}, {"radiance", {radiance}}, {"grid", {side}}}, to_world);
    return kit;
}

/// Place of the lamp: its local z axis, from where -z shines, leans towards +x.
Affine aslant() { return {{Vec3d{0.8, 0, 0.6}, {0, 1, 0}, {-0.6, 0, 0.8}}, {0.5, -0.3, 3}}; }

/// Irradiance at p, facing up, of points q with normal n that stand for equal parts of the area.
struct Points {
    Vec3d p;
    double area;
    double sum = 0;
    void add(Vec3d q, Vec3d n) {
        const Vec3d to = q - p;
        const double d2 = dot(to, to), d = std::sqrt(d2);
        const double at_lamp = std::max(0.0, -dot(to, n) / d), at_floor = std::max(0.0, to.z / d);
        sum += radiance * at_lamp * at_floor * area / (side * side) / d2;
    }
};

double middle(int i) { return (i + 0.5) / side; }

void expect_points(const SceneKit& kit, const Points& points) {
    EXPECT_NEAR(test::irradiance(kit.commit(), points.p, {0, 0, 1}, 1 << 14), points.sum, 2e-3 * points.sum);
}

TEST(LampGrid, OfARectangleIsTheSumOfItsPoints) {
    const Affine at = aslant();
    Points points{{0.2, 0.4, 0}, 2 * 1.5};
    for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j)
            points.add(at.point({2 * (middle(i) - 0.5), 1.5 * (middle(j) - 0.5), 0}), at.vector({0, 0, -1}));
    expect_points(lamp("area_light", "size", {2, 1.5}, at), points);
}

TEST(LampGrid, OfADiscIsTheSumOfItsPoints) {
    const Affine at = aslant();
    Points points{{0.2, 0.4, 0}, pi_d * 0.8 * 0.8};
    for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j) {
            const Vec2 d = sample_disc({static_cast<float>(middle(i)), static_cast<float>(middle(j))});
            points.add(at.point({0.8 * d.x, 0.8 * d.y, 0}), at.vector({0, 0, -1}));
        }
    expect_points(lamp("disk_light", "r", {0.8}, at), points);
}

TEST(LampGrid, OfABallIsTheSumOfThePointsInSight) {
    const Affine at = aslant();
    Points points{{0.2, 0.4, 0}, 4 * pi_d * 0.7 * 0.7};
    for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j) {
            const double z = 1 - 2 * middle(i), r = std::sqrt(1 - z * z), phi = 2 * pi_d * middle(j);
            const Vec3d n{r * std::cos(phi), r * std::sin(phi), z};
            points.add(at.t + n * 0.7, n);
        }
    expect_points(lamp("sphere_light", "r", {0.7}, at), points);
}

}  // namespace
}  // namespace cardioid
