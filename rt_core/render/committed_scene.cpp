#include "rt_core/render/committed_scene.hpp"

#include <algorithm>
#include <iterator>

#include "rt_core/render/commit/emissive_solid.hpp"
#include "rt_core/render/commit/make_lights.hpp"
#include "rt_core/render/commit/make_materials.hpp"
#include "rt_core/render/commit/scene_digest.hpp"

namespace cardioid {

namespace {

/// Surfaces in a row that a ray may pass because they bound nothing or only filter.
constexpr int most_passed = 10'000;
/// Lines that the power of emissive solids may take, of one and of all together: a quarter of a second. It only tells
/// how often a light is asked.
constexpr std::size_t all_power_lines = 1 << 20, fewest_power_lines = 1 << 12, most_power_lines = 1 << 18;
/// The ground lies this share of the model's size under it, so that it touches no face.
constexpr double ground_gap = 1e-4;

std::vector<bool> transparent(std::span<const Material> materials) {
    std::vector<bool> out;
    for (const Material& m : materials) out.push_back(m.shader->interior() != nullptr);
    return out;
}

/// Everything below a plane just under the model, made of the last material.
Geometry ground_under(const Geometry& model, const CompileSolids& compile, const std::vector<bool>& transparent) {
    const Box3d box = bounded_box(model);
    Scene ground;
    Leaf leaf;
    leaf.kind = LeafKind::half_space;
    leaf.material = static_cast<std::uint32_t>(transparent.size() - 1);
    if (!box.empty()) leaf.to_world = Affine::translation({0, 0, box.lo.z - ground_gap * box.diagonal()});
    ground.solids.roots.push_back(ground.solids.add_leaf(leaf));
    return compile(ground, transparent);
}

/// Whether some solid shines; a material that nothing is made of gives no light.
bool shines(const SolidTree& solids, std::span<const Material> materials) {
    return std::any_of(solids.leaves.begin(), solids.leaves.end(), [&](const Leaf& leaf) {
        return is_emissive(materials[leaf.material == Leaf::no_material ? 0 : leaf.material]);
    });
}

}  // namespace

CommittedScene::~CommittedScene() = default;

CommittedScene::CommittedScene(const Scene& scene, const Registry& registry, const CompileSolids& compile,
                               const CommitOptions& options)
    : materials_(make_materials(scene, registry)),
      lights_(make_lights(scene, registry)),
      face_count_(cardioid::face_count(scene.solids)) {
    Scene hashed = scene;
    if (lights_.empty() && !shines(scene.solids, materials_)) {
        if (options.studio) {
            Scene studio;
            studio.lights = hashed.lights = studio_lights(registry);
            lights_ = make_lights(studio, registry);
        }
        if (lights_.empty()) warnings_.push_back(scene.file + ": no light: all will be black");
    }
    hash_ = mix64(scene_hash(hashed) + (options.ground ? 1 : 0));

    if (options.ground) materials_.push_back(ground_material(registry));
    const std::vector<bool> clear = transparent(materials_);
    Geometry geometry = compile(scene, clear);
    if (geometry.regions.empty() && geometry.surfaces.empty())
        warnings_.push_back(scene.file + ": nothing to see: the scene has no solids");
    if (options.ground) {
        Geometry ground = ground_under(geometry, compile, clear);
        std::move(ground.regions.begin(), ground.regions.end(), std::back_inserter(geometry.regions));
        std::move(ground.shared.begin(), ground.shared.end(), std::back_inserter(geometry.shared));
        ++face_count_;
    }
    make_tracer(std::move(geometry));
    filters_ = std::any_of(materials_.begin(), materials_.end(), [](const Material& m) { return m.shader->filters(); });
    media_ = std::make_unique<Media>(*tracer_, materials_);
    add_emissive_lights();
    const Box3d box = bounds();
    for (const auto& light : lights_)
        light->prepare(box.empty() ? Vec3d{} : box.centre(), box.diagonal() > 0 ? box.diagonal() / 2 : 1);
    next_event_ = std::make_unique<NextEvent>(*this);
}

void CommittedScene::make_tracer(Geometry geometry) {
    std::vector<LampShape> lamps;
    for (std::size_t i = 0; i < lights_.size(); ++i)
        if (const auto shape = lights_[i]->shape()) {
            lamps.push_back(*shape);
            lamp_light_.push_back(static_cast<std::int32_t>(i));
        }
    if (!lamps.empty()) {
        black_material_ = static_cast<std::uint32_t>(materials_.size());
        materials_.push_back(black_material());
    }
    tracer_ = std::make_unique<Tracer>(std::move(geometry), lamps);
    for (std::size_t i = 0; i < lamps.size(); ++i)
        lights_[static_cast<std::size_t>(lamp_light_[i])]->set_face(tracer_->lamp_face(i));
}

void CommittedScene::add_emissive_lights() {
    std::vector<bool> emissive;
    for (const Material& m : materials_) emissive.push_back(is_emissive(m));
    const auto regions = tracer_->regions();
    const auto surfaces = tracer_->surfaces();
    region_light_.assign(regions.size() + surfaces.size(), -1);
    const auto add = [&](std::size_t id, std::unique_ptr<Light> light) {
        region_light_[id] = static_cast<std::int32_t>(lights_.size());
        lights_.push_back(std::move(light));
    };
    std::vector<std::uint32_t> emitting;
    for (std::size_t i = 0; i < regions.size(); ++i) {
        bool emits = false;
        for (std::uint32_t leaf = 0; leaf < regions[i]->leaf_count() && !emits; ++leaf)
            emits = emissive[regions[i]->material(leaf)];
        if (emits) emitting.push_back(static_cast<std::uint32_t>(i));
    }
    const auto most_lines = static_cast<std::uint32_t>(
        std::clamp(all_power_lines / std::max<std::size_t>(1, emitting.size()), fewest_power_lines, most_power_lines));
    for (const std::uint32_t i : emitting)
        add(i, std::make_unique<EmissiveRegion>(*regions[i], i, materials_, most_lines));
    for (std::size_t i = 0; i < surfaces.size(); ++i)
        if (emissive[surfaces[i].material]) {
            const std::size_t id = regions.size() + i;
            add(id, std::make_unique<EmissiveMesh>(surfaces[i], static_cast<std::uint32_t>(id), materials_));
        }
}

Hit CommittedScene::intersect(const Ray& ray) const noexcept {
    Hit hit = tracer_->intersect(ray);
    if (!media_->overlap()) return hit;
    Ray rest = ray;
    double passed = 0;
    for (int i = 0; i < most_passed && hit.found(); ++i) {
        const Vec3d p = rest.o + rest.d * hit.t;
        if (!media_->hides(p, hit)) break;
        passed += hit.t;
        rest = {p, ray.d, ray.t_max - passed, hit.id, hit.ng};
        hit = tracer_->intersect(rest);
    }
    hit.t += passed;
    return hit;
}

bool CommittedScene::occluded(const Ray& ray) const noexcept {
    return tracer_->occluded(ray) && (!media_->overlap() || intersect(ray).found());
}

Rgb CommittedScene::transmittance(const Ray& ray) const noexcept {
    if (!filters_) return Rgb(occluded(ray) ? 0.0F : 1.0F);
    Rgb share(1), first;  // absorption of the medium that the ray starts in
    const auto fade = [&](const Medium& medium, double length) {
        if (medium.absorption == first) return;
        share *= exp((first - medium.absorption) * static_cast<float>(std::min(length, 1e30)));
    };
    const Medium* beyond = nullptr;
    Ray rest = ray;
    for (int i = 0; i < most_passed; ++i) {
        const Hit hit = intersect(rest);
        if (!hit.found()) {
            if (beyond) fade(*beyond, rest.t_max);
            return share;
        }
        const SurfacePoint point = surface(rest, hit);
        if (point.lamp >= 0) return {};
        const bool outside = dot(Vec3d(point.ng), rest.d) < 0;
        if (i == 0) first = (outside ? point.front : point.back)->absorption;
        fade(outside ? *point.front : *point.back, hit.t);
        beyond = outside ? point.back : point.front;
        const Vec3 wo = point.frame.to_local(Vec3(-rest.d));
        share *= materials_[point.material].shader->straight_transmittance(point, wo);
        if (is_black(share)) return {};
        rest = {point.p, ray.d, rest.t_max - hit.t, hit.id, hit.ng};
    }
    return {};
}

SurfacePoint CommittedScene::surface(const Ray& ray, const Hit& found) const noexcept {
    Hit hit = found;
    tracer_->refine(ray, hit);
    SurfacePoint point{.p = ray.o + ray.d * hit.t, .ng = hit.ng, .frame = Frame(hit.ng), .id = hit.id};
    const std::int32_t lamp = tracer_->lamp(hit.id.region);
    if (lamp >= 0) {
        point.lamp = lamp_light_[static_cast<std::size_t>(lamp)];
        point.material = black_material_;
    } else {
        point.material = tracer_->material(hit);
    }
    const Interface sides = media_->around(point.p, hit);
    point.front = sides.front;
    point.back = sides.back;
    return point;
}

Rgb CommittedScene::emitted(const SurfacePoint& point, Vec3 wo) const noexcept {
    if (point.lamp >= 0) return lights_[static_cast<std::size_t>(point.lamp)]->emitted(point.p, point.ng, wo);
    return material_emission(materials_[point.material], point, wo);
}

std::int32_t CommittedScene::light_of(FaceId id) const noexcept {
    const std::int32_t lamp = tracer_->lamp(id.region);
    return lamp >= 0 ? lamp_light_[static_cast<std::size_t>(lamp)] : region_light_[id.region];
}

Rgb CommittedScene::escaped(Vec3 d) const noexcept {
    Rgb sum;
    for (const auto& light : lights_) sum += light->escaped(d);
    return sum;
}

Rgb CommittedScene::backdrop(Vec3 d) const noexcept {
    Rgb sum;
    for (const auto& light : lights_) sum += light->backdrop(d);
    return sum;
}

}  // namespace cardioid
