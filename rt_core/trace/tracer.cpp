#include "rt_core/trace/tracer.hpp"

#include "rt_core/trace/embree_scene.hpp"
#include "rt_core/trace/lamp_region.hpp"

namespace cardioid {

Tracer::~Tracer() = default;

Tracer::Tracer(Geometry geometry, const std::vector<LampShape>& lamps)
    : geometry_(std::move(geometry)), bounds_(bounded_box(geometry_)) {
    std::vector<EmbreeScene::Solid> solids;
    const auto add = [&](const Region& region, std::size_t id) {
        solids.push_back({&region, static_cast<std::uint32_t>(id)});
    };
    for (std::size_t i = 0; i < geometry_.regions.size(); ++i) add(*geometry_.regions[i], i);
    for (const LampShape& lamp : lamps) {
        lamps_.push_back(std::make_unique<LampRegion>(lamp));
        add(*lamps_.back(), first_lamp() + lamps_.size() - 1);
        bounds_.include(lamps_.back()->bounds());
    }
    embree_ = std::make_unique<EmbreeScene>(std::move(solids), geometry_.surfaces,
                                            static_cast<std::uint32_t>(geometry_.regions.size()),
                                            bounds_.empty() ? 1 : bounds_.diagonal());
}

std::size_t Tracer::first_lamp() const noexcept { return geometry_.regions.size() + geometry_.surfaces.size(); }

Hit Tracer::intersect(const Ray& ray) const noexcept { return embree_->intersect(ray); }
bool Tracer::occluded(const Ray& ray) const noexcept { return embree_->occluded(ray); }

void Tracer::refine(const Ray& ray, Hit& hit) const noexcept {
    if (!is_region(hit.id.region) && lamp(hit.id.region) < 0) embree_->refine(ray, hit);
}

std::int32_t Tracer::lamp(std::uint32_t id) const noexcept {
    return id != FaceId::none && id >= first_lamp() ? static_cast<std::int32_t>(id - first_lamp()) : -1;
}

FaceId Tracer::lamp_face(std::size_t lamp) const noexcept {
    return {static_cast<std::uint32_t>(first_lamp() + lamp), 0};
}

std::uint32_t Tracer::material(const Hit& hit) const noexcept {
    return is_region(hit.id.region) ? geometry_.regions[hit.id.region]->material(hit.leaf)
                                    : geometry_.surfaces[hit.id.region - geometry_.regions.size()].material;
}

TracerMemory Tracer::memory() const noexcept {
    TracerMemory m;
    for (const auto& region : geometry_.regions) {
        m.regions += region->memory_bytes();
        m.leaves += region->leaf_count();
    }
    for (const TriangleSurface& surface : geometry_.surfaces) {
        m.triangles += surface.mesh->vertices.capacity() * sizeof(Vec3d) + surface.mesh->triangles.capacity() * 12;
        m.triangle_count += surface.mesh->triangles.size();
    }
    m.triangles += embree_->vertex_bytes();
    m.embree = embree_->embree_bytes();
    return m;
}

}  // namespace cardioid
