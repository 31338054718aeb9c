#include "formats/brlcad/look/rt_lighting.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "formats/brlcad/look/rt_surface.hpp"
#include "rt_core/image/encode.hpp"
#include "rt_core/render/ray_counts.hpp"

namespace cardioid::formats {

namespace {

using brlcad::RtFinish;
using brlcad::RtSurface;

constexpr float ambient = 0.4F;  ///< rt's -A
constexpr int bounces = 5;       ///< mirrors and glass one way may pass (set bounces)
constexpr int reflections = 5;   ///< within one piece of glass (set ireflect)
constexpr int filters = 32;      ///< pieces of glass that a shadow ray may pass
/// Where an eye stands within a solid, rt pushes it on in vain six times, darkening by a fifth, then gives up with
/// grey.
const Rgb within_solid(0.18F * 0.8F * 0.8F * 0.8F * 0.8F * 0.8F * 0.8F);
const Rgb background{0, 0, 1.0F / 255};

/// What a display shows of numbers from 0 to 1, by a table whose chords are within 3e-8 of srgb_decode().
class Decoded {
public:
    Decoded() {
        for (std::size_t i = 0; i <= steps; ++i)
            at_[i] = srgb_decode(static_cast<float>(i) / static_cast<float>(steps));
        at_[steps + 1] = at_[steps];
    }
    [[nodiscard]] float operator()(float x) const noexcept {
        if (std::isnan(x)) return x;
        const float place = std::clamp(x, 0.0F, 1.0F) * static_cast<float>(steps);
        const auto i = static_cast<std::size_t>(place);
        return at_[i] + (at_[i + 1] - at_[i]) * (place - static_cast<float>(i));
    }

private:
    static constexpr std::size_t steps = 4096;
    std::array<float, steps + 2> at_;
};

struct Lamp {
    Vec3d place;
    Rgb colour;
    std::uint32_t material;
    bool shadows;
    float beam_cosine;
};

/// Schlick's stand-in for cosine^shine.
float highlight(float cosine, float shine) { return cosine / (shine - shine * cosine + cosine); }

class Tree {
public:
    Tree(const World& world, const std::vector<const RtFinish*>& finishes, const std::vector<Lamp>& lamps,
         const RtFinish* around)
        : world_(world), finishes_(finishes), lamps_(lamps), around_(around) {}

    /// What comes along the ray, in display values.
    Rgb along(const Ray& ray, int depth) const noexcept {
        const Hit hit = world_.intersect(ray);
        if (!hit.found()) return beyond(ray.d);
        const SurfacePoint point = world_.surface(ray, hit);
        const RtFinish* finish = finish_of(point.material);
        if (!finish) return {};
        if (depth == 0 && dot(point.ng, Vec3(ray.d)) > 0) return within_solid;
        const Rgb colour = finish->colour_at(point.p, point.ng);
        if (finish->flat) return colour;
        const Vec3 d(ray.d), n = dot(point.ng, d) < 0 ? point.ng : -point.ng;
        const float facing = -dot(n, d);
        if (finish->light > 0)
            return colour * (finish->light * ((-n.z < finish->beam_cosine ? 0 : 0.5F) + 0.5F * facing));
        const Spot spot{point, n, d, *finish, colour};
        Rgb c = colour * (ambient * facing);
        for (const Lamp& lamp : lamps_) c += lit(spot, lamp);
        if ((finish->reflect > 0 || finish->transmit > 0) && depth < bounces)
            c = c * (1 - finish->reflect - finish->transmit) + onward(spot, depth);
        return c;
    }

private:
    /// A point as it is shaded: n towards the eye, d away from it.
    struct Spot {
        const SurfacePoint& point;
        Vec3 n, d;
        const RtFinish& finish;
        Rgb colour;
    };

    /// What a ray sees that meets nothing: the envmap by azimuth and elevation.
    [[nodiscard]] Rgb beyond(Vec3d d) const noexcept {
        if (!around_) return background;
        if (!around_->texture) return around_->colour;
        constexpr double turn = 2 * std::numbers::pi;
        const double azimuth = std::atan2(d.y, d.x) / turn, elevation = std::atan2(d.z, std::hypot(d.x, d.y)) / turn;
        return around_->texture->at({azimuth < 0 ? azimuth + 1 : azimuth, 2 * elevation + 0.5});
    }

    /// Null where the material is none of rt's.
    [[nodiscard]] const RtFinish* finish_of(std::uint32_t material) const noexcept { return finishes_[material]; }

    [[nodiscard]] Rgb lit(const Spot& spot, const Lamp& lamp) const noexcept {
        const auto& [point, n, d, finish, colour] = spot;
        const Vec3d way = lamp.place - point.p;
        const double distance = length(way);
        const Vec3 to_light(way * (1 / distance));
        const float cosine = dot(n, to_light);
        if (!(cosine > 0) || to_light.z < lamp.beam_cosine) return {};
        const Rgb light = lamp.colour * arriving(point, to_light, distance, lamp);
        if (is_black(light)) return {};
        Rgb sum = light * colour * (cosine * finish.diffuse);
        const Vec3 mirrored = n * (2 * cosine) - to_light;
        if (const float c = -dot(mirrored, d); c > 0)
            sum += light * (finish.specular * highlight(std::min(c, 1.0F), finish.shine));
        return sum;
    }

    /// Share of a lamp's light that gets to the point, past glass.
    [[nodiscard]] Rgb arriving(const SurfacePoint& point, Vec3 to_light, double distance,
                               const Lamp& lamp) const noexcept {
        Rgb share(1);
        if (!lamp.shadows) return share;
        Ray ray = point.ray(to_light, distance);
        for (int i = 0; i < filters; ++i) {
            ++ray_counts.shadow;
            const Hit hit = world_.intersect(ray);
            if (!hit.found()) return share;
            const SurfacePoint at = world_.surface(ray, hit);
            if (at.material == lamp.material) return share;
            const RtFinish* finish = finish_of(at.material);
            if (!finish || finish->transmit <= 0) return {};
            if (dot(at.ng, to_light) < 0) share *= finish->colour * finish->transmit;
            distance -= hit.t;
            ray = at.ray(to_light, distance);
        }
        return share;
    }

    [[nodiscard]] Rgb onward(const Spot& spot, int depth) const noexcept {
        const auto& [point, n, d, finish, colour] = spot;
        Rgb sum;
        if (finish.reflect > 0) {
            ++ray_counts.specular;
            sum += along(point.ray(normalize(d - n * (2 * dot(n, d)))), depth + 1) * finish.reflect;
        }
        if (finish.transmit > 0) sum += through(spot, depth) * colour * finish.transmit;
        return sum;
    }

    /// Bends d where it passes from index a to b; false where all of it is reflected.
    static bool bend(Vec3& d, Vec3 n, float a, float b) noexcept {
        if (!(a > 0 && b > 0) || a == b) return true;
        const float eta = a / b, cosine = -dot(n, d), square = 1 - eta * eta * (1 - cosine * cosine);
        if (square < 0) {
            d = normalize(d + n * (2 * cosine));
            return false;
        }
        d = normalize(d * eta + n * (eta * cosine - std::sqrt(square)));
        return true;
    }

    /// Into the solid, to its far side and out.
    [[nodiscard]] Rgb through(const Spot& spot, int depth) const noexcept {
        const RtFinish& finish = spot.finish;
        Vec3 d = spot.d;
        static_cast<void>(bend(d, spot.n, 1, finish.index));
        Ray ray = spot.point.ray(d);
        for (int i = 0; i <= reflections; ++i) {
            ++ray_counts.specular;
            const Hit hit = world_.intersect(ray);
            if (!hit.found()) return beyond(ray.d);
            const SurfacePoint at = world_.surface(ray, hit);
            // Something else begins within the glass.
            if (dot(at.ng, d) < 0) return along(ray, depth + 1);
            if (bend(d, -at.ng, finish.index, 1)) return along(at.ray(d), depth + 1);
            ray = at.ray(d);
        }
        return finish.colour * ambient;
    }

    const World& world_;
    const std::vector<const RtFinish*>& finishes_;  ///< by material
    const std::vector<Lamp>& lamps_;
    const RtFinish* around_;
};

class RtLighting final : public LightingModule {
public:
    void prepare(const World& world, const Eye*, Progress&) override {
        for (std::size_t i = 0; i < world.materials().size(); ++i) {
            const auto* surface = dynamic_cast<const RtSurface*>(world.materials()[i].shader.get());
            finishes_.push_back(surface ? &surface->finish() : nullptr);
            if (surface && surface->finish().around) around_ = &surface->finish();
            if (!surface || !(surface->finish().light > 0)) continue;
            const RtFinish& f = surface->finish();
            lamps_.push_back({f.place, f.colour * f.light, static_cast<std::uint32_t>(i), f.shadows, f.beam_cosine});
        }
    }
    [[nodiscard]] std::optional<LightParts> incoming(const World& world, const EyeRay& eye,
                                                     Sampler&) const noexcept override {
        std::vector<Lamp> implicit;
        if (lamps_.empty()) {
            // Half the picture to the left of the eye and as much behind it; without a picture's size, far away there.
            const Vec3 back(-eye.ray.d);
            const Vec3 left = normalize(cross(back, std::abs(back.z) < 0.99F ? Vec3{0, 0, 1} : Vec3{0, 1, 0}));
            const double far = std::max(world.bounds().diagonal(), 1.0);
            implicit.push_back(
                {world.bounds().centre() + Vec3d(back + left) * far, Rgb(1 / (1 + 0.5F * ambient)), ~0U, false, -1});
        }
        const Rgb c = Tree(world, finishes_, lamps_.empty() ? implicit : lamps_, around_).along(eye.ray, 0);
        LightParts out;
        // A picture is written as a display shows it; rt writes its numbers as they are.
        out.direct = {decoded_(c.r), decoded_(c.g), decoded_(c.b)};
        return out;
    }

private:
    Decoded decoded_;
    std::vector<const RtFinish*> finishes_;
    std::vector<Lamp> lamps_;
    const RtFinish* around_ = nullptr;
};

std::unique_ptr<LightingModule> make(const Params&, std::uint32_t) { return std::make_unique<RtLighting>(); }

}  // namespace

const LightingKind rt_lighting{"rt", "as BRL-CAD's rt lights its models, for comparing with it", {}, make};

}  // namespace cardioid::formats
