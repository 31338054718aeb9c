#include "bench/cornell_box.hpp"

namespace cardioid::bench {
namespace {

/// From the published coordinates (y up, z away from the eye) to ours.
const Affine upright{{Vec3d{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}, {}};

enum Paint : std::uint32_t { white, red, green, mirror, glass };

class Builder {
public:
    Builder() {
        scene_.file = "cornell";
        paint("diffuse", "reflectance", {0.73, 0.73, 0.73});
        paint("diffuse", "reflectance", {0.63, 0.065, 0.05});
        paint("diffuse", "reflectance", {0.14, 0.45, 0.091});
        paint("mirror", "reflectance", {1, 1, 1});
        paint("dielectric", "ior", {1.5});
        box({-10, -10, 0}, {580, 10, 559.2}, white);
        box({-10, 548.8, 0}, {580, 10, 559.2}, white);
        box({-10, -10, 559.2}, {580, 568.8, 10}, white);
        box({-10, 0, 0}, {10, 548.8, 559.2}, green);
        prism({{552.8, 0}, {570, 0}, {570, 548.8}, {556, 548.8}}, 559.2, upright, red);
        lamp();
        CameraSettings camera;
        camera.eye = {278, 800, 273}, camera.look_at = {278, 0, 273};
        camera.fov_deg = 39.3076889;
        scene_.cameras.push_back(camera);
    }
    void block(std::vector<Vec2d> corners, double height) {
        const Affine lying{{Vec3d{1, 0, 0}, {0, 0, 1}, {0, -1, 0}}, {}};
        prism(std::move(corners), height, upright * lying, white);
    }
    void ball(Vec3d centre, double r, Paint paint) {
        add(LeafKind::sphere, upright * Affine::translation(centre) * Affine::scaling({r, r, r}), paint);
    }
    [[nodiscard]] Scene done() && { return std::move(scene_); }

private:
    void paint(const char* kind, const char* name, std::vector<double> values) {
        Params params("cornell");
        const bool list = values.size() > 1;
        params.set(name, ParamValue{.numbers = std::move(values), .list = list});
        scene_.materials.push_back({std::string(kind) + std::to_string(scene_.materials.size()), kind, params});
    }
    Leaf& add(LeafKind kind, const Affine& to_world, Paint paint) {
        Leaf leaf;
        leaf.kind = kind, leaf.to_world = to_world, leaf.material = paint;
        scene_.solids.roots.push_back(scene_.solids.add_leaf(leaf));
        return scene_.solids.leaves.back();
    }
    void box(Vec3d at, Vec3d size, Paint paint) {
        add(LeafKind::box, upright * Affine::translation(at) * Affine::scaling(size), paint);
    }
    void prism(std::vector<Vec2d> corners, double height, const Affine& to_world, Paint paint) {
        Leaf& leaf = add(LeafKind::prism, to_world * Affine::scaling({1, 1, height}), paint);
        leaf.a = 1;
        leaf.data = scene_.solids.add_profile({{std::move(corners)}});
    }
    void lamp() {
        const Affine at{{Vec3d{1, 0, 0}, {0, 0, 1}, {0, -1, 0}}, {278, 548.3, 279.5}};
        LightSettings lamp{"area_light", Params("cornell"), upright * at};
        lamp.params.set("size", ParamValue{.numbers = {130, 105}, .list = true});
        lamp.params.set("radiance", ParamValue{.numbers = {18.4, 15.6, 8.0}, .list = true});
        scene_.lights.push_back(std::move(lamp));
    }

    Scene scene_;
};

}  // namespace

Scene cornell_blocks() {
    Builder builder;
    builder.block({{130, -65}, {82, -225}, {240, -272}, {290, -114}}, 165);
    builder.block({{423, -247}, {265, -296}, {314, -456}, {472, -406}}, 330);
    return std::move(builder).done();
}

Scene cornell_balls() {
    Builder builder;
    builder.ball({400, 100, 390}, 100, mirror);
    builder.ball({165, 100, 190}, 100, glass);
    return std::move(builder).done();
}

}  // namespace cardioid::bench
