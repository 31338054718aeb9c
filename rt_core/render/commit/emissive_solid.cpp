#include "rt_core/render/commit/emissive_solid.hpp"

#include <bit>

#include "rt_core/api/parallel.hpp"
#include "rt_core/render/commit/make_materials.hpp"
#include "rt_core/render/commit/seen_box.hpp"

namespace cardioid {

namespace {

/// Independent sequences of lines, how many each has at first, and the standard error of the power that ends them.
constexpr std::uint32_t sequences = 8, first_lines = 64;
constexpr double power_error = 5e-4;
/// Steps of a sequence of points in four dimensions: powers of the positive root of x^5 = x + 1, inverted (Roberts
/// 2018, the R-sequences). Its points lie more evenly than pairs of a plane sequence.
constexpr std::array<double, 4> steps{0.8566748838545029, 0.7338918566271260, 0.6287067210378087, 0.5385972572236101};
/// Boundaries on one line; more are not walked.
constexpr int most_crossings = 100'000;
/// Rounding must not put a point of the solid outside the sphere or the box.
constexpr double margin = 1 + 1e-4;

/// 1 - cos of the half angle under which p sees the sphere; 2 from inside.
double cone_from(Vec3d to_centre, double radius) {
    const double d2 = dot(to_centre, to_centre);
    if (!(d2 > radius * radius)) return 2;
    const double sin2 = radius * radius / d2;
    return sin2 / (1 + std::sqrt(1 - sin2));
}

/// As a float, which rounding must not take to 1.
float below_one(double u) { return std::min(static_cast<float>(u), 0x1.fffffep-1F); }

SurfacePoint point_on(Vec3d p, Vec3 ng, FaceId id, std::uint32_t material) {
    SurfacePoint point;
    point.p = p;
    point.ng = ng;
    point.frame = Frame(ng);
    point.id = id;
    point.material = material;
    return point;
}

Box3d bounds_of(const TriangleSurface& surface) {
    Box3d box;
    for (const Vec3d v : surface.mesh->vertices) box.include(surface.to_world.point(v));
    return box;
}

}  // namespace

EmissiveSolid::EmissiveSolid(const Box3d& bounds, bool is_ball) : radius_(Box3d::infinity) {
    if (!bounds.bounded()) return;
    centre_ = bounds.centre();
    radius_ = (is_ball ? bounds.size().x / 2 : bounds.diagonal() / 2) * margin;
    if (!is_ball) box_ = bounds.padded((margin - 1) * radius_);
}

LightSample EmissiveSolid::sample(Vec3d p, Vec2 u) const noexcept {
    LightSample out;
    out.distance = Box3d::infinity;
    out.trace = true;
    if (!box_.empty()) {
        const SeenBox seen(box_, p);
        if (seen.in_sight()) {
            const SeenBox::Direction way = seen.sample(u);
            out.wi = Vec3(way.d), out.pdf = static_cast<float>(way.pdf);
        } else {
            out.wi = sample_sphere(u), out.pdf = inv_pi / 4;
        }
        return out;
    }
    const Vec3d to_centre = centre_ - p;
    const double cone = cone_from(to_centre, radius_);
    const Vec3 local = sample_cone(u, static_cast<float>(cone));
    out.wi = cone < 2 ? Frame(Vec3(normalize(to_centre))).to_world(local) : local;
    out.pdf = inv_pi / 2 / static_cast<float>(cone);
    return out;
}

float EmissiveSolid::pdf(Vec3d p, Vec3 wi) const noexcept {
    if (!box_.empty()) {
        const SeenBox seen(box_, p);
        return seen.in_sight() ? static_cast<float>(seen.pdf(Vec3d(wi))) : inv_pi / 4;
    }
    const Vec3d to_centre = centre_ - p;
    const double cone = cone_from(to_centre, radius_);
    if (cone < 2) {
        // 1 - cos(angle) of wi to the axis from the chord, which keeps its digits where the angle is small.
        const Vec3d chord = Vec3d(wi) - normalize(to_centre);
        if (dot(chord, chord) / 2 > cone) return 0;
    }
    return inv_pi / 2 / static_cast<float>(cone);
}

EmissiveRegion::EmissiveRegion(const Region& region, std::uint32_t id, std::span<const Material> materials,
                               std::uint32_t most_lines)
    : EmissiveSolid(region.bounds(), region.is_ball()),
      region_(region),
      id_(id),
      materials_(materials),
      most_lines_(most_lines) {}

Ray EmissiveRegion::line(Vec2 u_place, Vec2 u_direction) const noexcept {
    // The direction first, so that these numbers mean a direction in the world and photons can be aimed by them.
    const Vec3 d = -sample_sphere(u_direction);
    const Vec3 outward = Frame(-d).to_world(sample_cosine_hemisphere(u_place));
    return {centre_ + Vec3d(outward) * radius_, Vec3d(d), 2.1 * radius_, {}, {}};
}

template <class Use>
void EmissiveRegion::walk(const Ray& line, Use&& use) const noexcept {
    Ray ray = line;
    Hit hit;
    for (int i = 0; i < most_crossings && region_.first_boundary(ray, id_, hit); ++i) {
        hit.id.region = id_;
        ray.o = ray.o + ray.d * hit.t;
        ray.t_max -= hit.t;
        ray.from = hit.id;
        ray.from_ng = hit.ng;
        if (dot(Vec3d(hit.ng), ray.d) < 0) {
            const std::uint32_t m = region_.material(hit.leaf);
            use(Crossing{hit, ray.o,
                         material_emission(materials_[m], point_on(ray.o, hit.ng, hit.id, m), Vec3(-ray.d))});
        }
        hit = {};
    }
}

void EmissiveRegion::prepare(Vec3d centre, double radius) {
    if (!std::isfinite(radius_)) {
        centre_ = centre;
        radius_ = radius;
    }
    std::optional<BoxLines> box;
    if (region_.bounds().bounded()) box.emplace(region_.bounds());
    const double measure = box ? box->measure() : 4 * std::numbers::pi * std::numbers::pi * radius_ * radius_;
    std::array<LineSums, sequences> sums;
    const std::uint32_t most = most_lines_ / sequences;
    for (std::uint32_t done = 0, next = first_lines; done < most; next = std::min(2 * next, most)) {
        parallel_for(sequences, [&](std::int64_t g) {
            add_lines(box, static_cast<std::uint32_t>(g), done, next, sums[static_cast<std::size_t>(g)]);
        });
        done = next;
        if (set_power(sums, measure / done) <= power_error) return;
    }
}

/// Takes the power from sums in which a line stands for `a_line` [unit^2 sr]; returns its relative standard error.
double EmissiveRegion::set_power(std::span<const LineSums> all, double a_line) noexcept {
    const double area = region_.area(), n = static_cast<double>(all.size());
    std::array<double, 3> mean{};
    double sum = 0, squares = 0;
    for (const LineSums& s : all) {
        const double unit = area > 0 ? std::numbers::pi * area / std::max(s.entries, 1.0) : a_line;
        for (std::size_t c = 0; c < 3; ++c) mean[c] += s.L[c] * unit / n;
        const double flux = (s.L[0] + s.L[1] + s.L[2]) * unit;
        sum += flux;
        squares += flux * flux;
    }
    power_ = {static_cast<float>(mean[0]), static_cast<float>(mean[1]), static_cast<float>(mean[2])};
    const double variance = std::max(0.0, squares / n - sum * sum / (n * n));
    return sum > 0 ? std::sqrt(variance / (n - 1)) * n / sum : 1;
}

void EmissiveRegion::add_lines(const std::optional<BoxLines>& box, std::uint32_t sequence, std::uint32_t first,
                               std::uint32_t last, LineSums& sums) const noexcept {
    Sampler sampler(0, Purpose::statistics, id_, sequence);
    const Vec2 a = sampler.next2(), b = sampler.next2();
    const std::array<double, 4> shift{a.x, a.y, b.x, b.y};
    for (std::uint32_t i = first; i < last; ++i) {
        std::array<double, 4> u;
        for (std::size_t k = 0; k < 4; ++k) {
            const double x = shift[k] + i * steps[k];
            u[k] = x - std::floor(x);
        }
        const Vec2 place(below_one(u[0]), below_one(u[1])), direction(below_one(u[2]), below_one(u[3]));
        walk(box ? box->line(u) : line(place, direction), [&](const Crossing& c) {
            sums.L[0] += c.L.r, sums.L[1] += c.L.g, sums.L[2] += c.L.b;
            ++sums.entries;
        });
    }
}

LightEmission EmissiveRegion::emit(Vec2 u_place, Vec2 u_direction) const noexcept {
    const Ray ray = line(u_place, u_direction);
    std::uint64_t count = 0;
    walk(ray, [&](const Crossing& c) { count += !is_black(c.L); });
    LightEmission out;
    if (count == 0) return out;
    // One of the crossings, chosen by the bits of the same numbers, stands for all.
    const std::uint64_t bits = std::uint64_t{std::bit_cast<std::uint32_t>(u_place.x)} << 32 ^
                               std::uint64_t{std::bit_cast<std::uint32_t>(u_direction.y)} << 16 ^
                               std::bit_cast<std::uint32_t>(u_direction.x);
    std::uint64_t chosen = mix64(bits) % count;
    const double measure = std::numbers::pi * 4 * std::numbers::pi * radius_ * radius_ * static_cast<double>(count);
    walk(ray, [&](const Crossing& c) {
        if (is_black(c.L) || chosen-- != 0) return;
        out.ray = {c.p, -ray.d, Box3d::infinity, c.hit.id, c.hit.ng};
        out.flux = c.L * static_cast<float>(measure);
    });
    return out;
}

EmissiveMesh::EmissiveMesh(const TriangleSurface& surface, std::uint32_t id, std::span<const Material> materials)
    : EmissiveSolid(bounds_of(surface), false), surface_(surface), id_(id), material_(materials[surface.material]) {
    double total = 0;
    double sum[3] = {};
    for (std::size_t i = 0; i < surface.mesh->triangles.size(); ++i) {
        const auto [a, b, c] = corners(i);
        const Vec3d normal = cross(b - a, c - a);
        const double area = length(normal) / 2;
        total += area;
        area_.push_back(total);
        if (!(area > 0)) continue;
        const Vec3 ng(normalize(normal));
        const Rgb L = material_emission(material_, point_on((a + b + c) / 3.0, ng, {id_, 0}, surface.material), ng);
        sum[0] += L.r * area, sum[1] += L.g * area, sum[2] += L.b * area;
    }
    power_ = Rgb(static_cast<float>(sum[0]), static_cast<float>(sum[1]), static_cast<float>(sum[2])) * pi;
}

EmissiveMesh::Corners EmissiveMesh::corners(std::size_t triangle) const {
    const auto& index = surface_.mesh->triangles[triangle];
    Corners out;
    for (std::size_t i = 0; i < 3; ++i) out[i] = surface_.to_world.point(surface_.mesh->vertices[index[i]]);
    // A mirroring placement turns the triangles over.
    if (surface_.to_world.determinant() < 0) std::swap(out[1], out[2]);
    return out;
}

LightEmission EmissiveMesh::emit(Vec2 u_place, Vec2 u_direction) const noexcept {
    LightEmission out;
    const double total = area_.empty() ? 0 : area_.back();
    if (!(total > 0)) return out;
    const double wanted = u_place.x * total;
    const std::size_t i =
        std::min(static_cast<std::size_t>(std::upper_bound(area_.begin(), area_.end(), wanted) - area_.begin()),
                 area_.size() - 1);
    const double before = i == 0 ? 0 : area_[i - 1];
    const double along =
        area_[i] > before ? std::sqrt(std::clamp((wanted - before) / (area_[i] - before), 0.0, 1.0)) : 0;
    const auto [a, b, c] = corners(i);
    const Vec3 ng(normalize(cross(b - a, c - a)));
    const Vec3d p = a + (b - a) * (along * (1 - u_place.y)) + (c - a) * (along * u_place.y);
    const FaceId face{id_, static_cast<std::uint32_t>(i)};
    const Vec3 d = Frame(ng).to_world(sample_cosine_hemisphere(u_direction));
    out.ray = {p, Vec3d(d), Box3d::infinity, face, ng};
    out.flux = material_emission(material_, point_on(p, ng, face, surface_.material), d) *
               static_cast<float>(total * std::numbers::pi);
    return out;
}

}  // namespace cardioid
