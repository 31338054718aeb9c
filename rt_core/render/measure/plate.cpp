#include "rt_core/render/measure/plate.hpp"

#include <optional>

namespace cardioid {

namespace {

/// Points are written with six digits or more, so that one of a surface lies this share of its coordinates off it ...
constexpr double reach_share = 1e-5;
/// ... and near the origin this share of the scene's size takes the part of the coordinates (as in EmbreeScene).
constexpr double origin_share = 1e-3;
/// Faces that do not look to the lit side must be nearer by this: in front of them there may be a gap to measure.
constexpr double near_share = 0.1;
/// cos 60 degrees.
constexpr float facing = 0.5F;
/// Boundaries on one short line.
constexpr int most_boundaries = 16;
/// Cosine to its own horizon from where on a plate lies flat, up to rounding.
constexpr float flat = 1 - 1e-6F;

}  // namespace

BsdfSample PlateBsdf::sample(Vec3 wo, float, Vec2 u, Lobe which) const noexcept {
    if (!any(which & Lobe::diffuse) || wo.z == 0) return {};
    Vec3 wi = sample_cosine_hemisphere(u);
    if (wi.z <= 0) return {};
    const float density = wi.z * inv_pi;
    if (wo.z < 0) wi.z = -wi.z;
    if (dot(horizon_, wi) < 0) return {};
    return {wi, Rgb(1), density, Lobe::diffuse};
}

/// Looks around p for the face that the plate lies on, by short lines.
class PlateFinder::Search {
public:
    Search(const CommittedScene& scene, double scale, Vec3d p, Vec3 d)
        : scene_(scene), p_(p), d_(d), reach_(reach_share * (max_component(abs(p)) + origin_share * scale)) {}

    /// The point of the best face, moved to where p lies on it.
    std::optional<SurfacePoint> find() {
        const Frame frame(d_);
        const Vec3d d(d_), s(frame.s), t(frame.t);
        // Within 60 degrees a face `reach` away is at most twice as far along d.
        along(p_, -d, reach_ / facing);
        // Beside it too: on an edge the line through p itself may miss.
        for (const double i : {-0.25, 0.25})
            for (const double j : {-0.25, 0.25}) along(p_ + (s * i + t * j) * reach_, -d, reach_ / facing);
        along(p_, s, reach_);
        along(p_, t, reach_);
        if (rank_ == none) return std::nullopt;
        settle();
        return best_;
    }

private:
    static constexpr int none = 3;

    void along(Vec3d middle, Vec3d direction, double reach) {
        Ray ray{middle - direction * reach, direction, 2 * reach, {}, {}};
        for (int i = 0; i < most_boundaries; ++i) {
            const Hit hit = scene_.intersect(ray);
            if (!hit.found()) return;
            const SurfacePoint found = scene_.surface(ray, hit);
            consider(found);
            ray = {found.p, direction, ray.t_max - hit.t, found.id, found.ng};
        }
    }

    void consider(const SurfacePoint& found) {
        const double height = std::abs(dot(p_ - found.p, Vec3d(found.ng)));
        const float cosine = dot(found.ng, d_);
        if (height > (cosine > 0 ? reach_ : near_share * reach_)) return;
        const int rank = cosine > facing ? 0 : cosine > 0 ? 1 : 2;
        // Of equally near faces the first counts: the one straight under p.
        if (rank > rank_ || (rank == rank_ && height >= height_ - 1e-3 * reach_)) return;
        rank_ = rank;
        height_ = height;
        best_ = found;
    }

    /// Moves the best point straight under or over p.
    void settle() {
        const Vec3d n(best_.ng);
        const Ray down{p_ + n * reach_, -n, 2 * reach_, {}, {}};
        const Hit hit = scene_.intersect(down);
        if (hit.found() && hit.id == best_.id)
            best_ = scene_.surface(down, hit);
        else
            best_.p = p_ - n * dot(p_ - best_.p, n);
    }

    const CommittedScene& scene_;
    Vec3d p_;
    Vec3 d_;
    double reach_;  ///< scene units
    SurfacePoint best_;
    int rank_ = none;  ///< 0: looks to the lit side, 1: a little, 2: elsewhere
    double height_ = 0;
};

PlateFinder::PlateFinder(const CommittedScene& scene)
    : scene_(scene), scale_(scene.bounds().empty() ? 1 : scene.bounds().diagonal()) {
    for (const auto& region : scene.tracer().regions())
        if (!region->bounds().bounded() && !scene.materials()[region->material(0)].shader->interior())
            unbounded_.push_back(region.get());
}

bool PlateFinder::is_opaque(const SurfacePoint& point) const noexcept {
    return point.lamp >= 0 || !scene_.materials()[point.material].shader->interior();
}

/// Whether there is an inside behind the face: plates of lamps and open meshes have none.
bool PlateFinder::is_solid(FaceId id, std::int32_t lamp) const noexcept {
    if (lamp >= 0) {
        const auto shape = scene_.lights()[static_cast<std::size_t>(lamp)]->shape();
        return shape && shape->kind == LampShape::Kind::sphere;
    }
    const Tracer& tracer = scene_.tracer();
    return tracer.is_region(id.region) || tracer.surfaces()[id.region - tracer.regions().size()].mesh->closed;
}

/// Whether the place where the ray begins, on the side of n, is inside an opaque solid: what it meets first is then
/// that solid from within, but for solids without end.
bool PlateFinder::is_buried(const Ray& ray, Vec3 n) const noexcept {
    for (const Region* region : unbounded_)
        if (region->sides(ray.o, Vec3d(n)).front) return true;
    const Hit hit = scene_.intersect(ray);
    if (!hit.found() || dot(Vec3d(hit.ng), ray.d) <= 0) return false;
    const SurfacePoint wall = scene_.surface(ray, hit);
    if (!is_opaque(wall) || !is_solid(hit.id, wall.lamp)) return false;
    const Tracer& tracer = scene_.tracer();
    return !tracer.is_region(hit.id.region) || tracer.regions()[hit.id.region]->sides(ray.o, Vec3d(n)).front;
}

/// What an opaque face under the plate does; returns the direction from which light may come.
Vec3 PlateFinder::lay(Plate& plate) const noexcept {
    const SurfacePoint& point = plate.point;
    if (!is_opaque(point)) return plate.normal;
    const float cosine = dot(point.ng, plate.normal);
    const bool turned = cosine < 0 && !is_solid(point.id, point.lamp);
    const Vec3 up = turned ? -point.ng : point.ng;
    plate.buried = !turned && cosine < -flat;
    if (std::abs(cosine) < flat) plate.horizon = point.frame.to_local(up);
    return up;
}

Plate PlateFinder::place(Vec3d p, Vec3 d) const noexcept {
    Plate plate;
    plate.normal = d;
    if (const std::optional<SurfacePoint> found = Search(scene_, scale_, p, d).find()) {
        plate.point = *found;
        const bool outer = dot(found->ng, d) >= 0;
        plate.point.frame = Frame(outer ? d : -d);
        const Vec3 open = lay(plate);
        const Vec3 side = dot(found->ng, open) > 0 ? found->ng : -found->ng;
        plate.buried = plate.buried || is_buried(plate.point.ray(open), side);
    } else {
        plate.point.p = p;
        plate.point.ng = d;
        plate.point.frame = Frame(d);
        plate.point.front = plate.point.back = scene_.medium_at(p);
        plate.buried = is_buried(plate.point.ray(d), d);
    }
    // It receives light; it does not shine, whatever it lies on.
    plate.point.lamp = -1;
    return plate;
}

}  // namespace cardioid
