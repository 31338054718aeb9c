#pragma once
#include "rt_core/render/lighting/light_choice.hpp"
#include "rt_core/render/lighting/next_event.hpp"

namespace cardioid {

/// What a walk needs besides the world and the numbers it draws.
struct PathSettings {
    int depth;  ///< most surfaces between the light and the eye
};

/// Follows light backwards, from the eye or from a point that scatters it, as far as it goes: at every point with lobes
/// of finite width one light is asked, and one direction of the Bsdf goes on; what it finds of the lights is weighed
/// against what was asked for (Veach 1997, section 9.2). Russian roulette by the throughput ends the path (Arvo, Kirk
/// 1990). Nothing is cut off, so the mean of many walks is the truth.
class LightPath {
public:
    LightPath(const World& world, const NextEvent& next_event, const LightChoice& choice, const PathSettings& settings,
              Sampler& sampler)
        : world_(world), next_event_(next_event), choice_(choice), settings_(settings), sampler_(sampler) {}

    /// All light that comes along a ray from the eye.
    [[nodiscard]] LightParts from_eye(const EyeRay& eye) noexcept;
    /// LightParts::caustic and ::indirect of the light that leaves `point` along wo (world) by its non-delta lobes; the
    /// latter is left out where `caustic_only`.
    [[nodiscard]] LightParts from_point(const SurfacePoint& point, const Bsdf& bsdf, Vec3 wo,
                                        bool caustic_only) noexcept;

private:
    /// How the path came to where it is, seen from the eye: by nothing, by mirrors and glass, by one point of finite
    /// lobes (x1) straight, by it and mirrors and glass, by more such points.
    enum class Stage { eye, behind, direct, caustic, indirect };

    void follow() noexcept;
    [[nodiscard]] bool step() noexcept;
    void arrive(const SurfacePoint& point, Vec3 wo) noexcept;
    void escape() noexcept;
    void ask_light(const SurfacePoint& point, const Bsdf& bsdf, Vec3 wo_local) noexcept;
    [[nodiscard]] bool bounce(const SurfacePoint& point, const Bsdf& bsdf, Vec3 wo_local, Lobe which) noexcept;
    [[nodiscard]] bool survives() noexcept;
    [[nodiscard]] bool filters(const SurfacePoint& point) const noexcept;
    [[nodiscard]] float share_of_ray(std::size_t light) const noexcept;
    void add(Rgb L) noexcept;

    const World& world_;
    const NextEvent& next_event_;
    const LightChoice& choice_;
    const PathSettings& settings_;
    Sampler& sampler_;

    LightParts parts_;
    Stage stage_ = Stage::eye;
    Ray ray_;
    const Medium* medium_ = nullptr;
    Rgb throughput_{1};
    float squeeze_ = 1;    ///< of radiance in denser media: (index here / index at the start)^2
    float per_first_ = 1;  ///< over what was carried to the first point of finite lobes
    int bounces_ = 0;      ///< surfaces on the way but filters
    int steps_ = 0;        ///< surfaces on the way
    bool unbent_ = true;   ///< straight from the eye
    bool caustic_only_ = false;
    bool has_spare_ = false;
    Vec2 spare_;  ///< numbers for the roulette
    double pixel_ = 0, spread_ = 0, distance_ = 0;

    // Where a light was last asked, and the density [1/sr] of the ray that went on from there; 0 after a mirror or
    // glass, from where no light could be asked.
    Vec3d asked_;
    const Bsdf* asked_bsdf_ = nullptr;
    float ray_pdf_ = 0;
    int memory_ = 0;
    BsdfMemory memories_[2];  ///< in turn, so that the Bsdf asked last stays
};

}  // namespace cardioid
