#pragma once
#include <atomic>
#include <memory>

#include "photon/gather/glossy_caustics.hpp"
#include "photon/lighting/eye_caches.hpp"
#include "photon/lighting/shown_place.hpp"

namespace cardioid::photon {

/// Photon mapping as the renderer asks for it (ARL-TR-3608). Maps and caches are made by prepare() and read from then
/// on by any thread.
class PhotonModule final : public LightingModule {
public:
    PhotonModule(const PhotonOptions& options, std::uint32_t seed) : options_(options), seed_(seed) {}

    void prepare(const World& world, const Eye* eye, Progress& progress) override;
    [[nodiscard]] Rgb indirect(const World& world, const SurfacePoint& point, const Bsdf& bsdf, Vec3 wo,
                               Sampler& sampler) const noexcept override;
    [[nodiscard]] Rgb caustic(const World& world, const SurfacePoint& point, const Bsdf& bsdf, Vec3 wo,
                              Sampler& sampler) const noexcept override;
    [[nodiscard]] std::vector<std::string> views() const override;
    [[nodiscard]] Rgb view(const std::string& name, const World& world,
                           const SurfacePoint& point) const noexcept override;
    [[nodiscard]] std::vector<Statistic> statistics() const override;
    void save(const std::string& path) const override;
    void load(const std::string& path, const World& world, const Eye* eye, Progress& progress) override;

private:
    void make_maps(const World& world, const Eye* eye, Progress& progress);
    void load_maps(const std::string& path, const World& world, const Eye* eye, Progress& progress);
    void look_up_from(const World& world, const Eye* eye, const Tuning& tuning, Progress& progress);
    [[nodiscard]] Rgb density(const World& world, const PhotonMap& map, const SurfacePoint& point) const noexcept;
    [[nodiscard]] Rgb diffuse_irradiance(const World& world, const SurfacePoint& point, const Bsdf& bsdf, Vec3 wo,
                                         Sampler& sampler) const noexcept;

    PhotonOptions options_;
    std::uint32_t seed_;
    std::uint64_t scene_ = 0;  ///< World::hash()
    LightMaps maps_;
    std::optional<IncomingLight> incoming_;
    std::optional<GlossyCaustics> glossy_caustics_;
    EyeCaches caches_;
    std::optional<ShownPlace> shown_;
    std::vector<Statistic> times_;  ///< of the phases of prepare() or load()
    /// Lookups that no cache point reached; counted for statistics alone.
    mutable std::atomic<std::uint64_t> missed_{0};
};

}  // namespace cardioid::photon
