/// `rt_surface`: a surface of BRL-CAD's rt, made by `--set brlcad.look=rt` and drawn by `--lighting rt`.
#include "formats/brlcad/look/rt_surface.hpp"

#include <cmath>
#include <map>

#include "rt_core/math/sampling.hpp"

namespace cardioid::formats::brlcad {

namespace {

class MattBsdf final : public Bsdf {
public:
    explicit MattBsdf(Rgb colour) : colour_(colour) {}
    [[nodiscard]] Lobe lobes() const noexcept override { return Lobe::diffuse; }
    [[nodiscard]] Rgb f(Vec3 wo, Vec3 wi) const noexcept override { return wo.z * wi.z > 0 ? colour_ * inv_pi : Rgb{}; }
    [[nodiscard]] float pdf(Vec3 wo, Vec3 wi, Lobe which) const noexcept override {
        return wo.z * wi.z > 0 && any(which & Lobe::diffuse) ? std::abs(wi.z) * inv_pi : 0;
    }
    [[nodiscard]] BsdfSample sample(Vec3 wo, float, Vec2 u, Lobe which) const noexcept override {
        Vec3 wi = sample_cosine_hemisphere(u);
        if (!any(which & Lobe::diffuse) || wo.z == 0 || wi.z <= 0) return {};
        if (wo.z < 0) wi.z = -wi.z;
        return {wi, colour_, std::abs(wi.z) * inv_pi, Lobe::diffuse};
    }
    [[nodiscard]] Albedo albedo(Vec3) const noexcept override { return {.diffuse = colour_}; }

private:
    Rgb colour_;
};

/// Pixels along a side of an image.
constexpr double most_pixels = 16384;

constexpr ParamSpec params[] = {
    {"colour", ParamType::colour, "1", "of the region, as a display has it, 0 to 1"},
    {"shine", ParamType::number, "10", "sharpness of the highlight"},
    {"specular", ParamType::number, "0.7", "share of the highlight"},
    {"diffuse", ParamType::number, "0.3", "share of the light from lamps"},
    {"transmit", ParamType::number, "0", "share that goes through, 0 to 1"},
    {"reflect", ParamType::number, "0", "share that is mirrored, 0 to 1"},
    {"index", ParamType::number, "1", "of refraction; 0 bends nothing"},
    {"flat", ParamType::number, "0", "1: the colour as it is, without light"},
    {"around", ParamType::number, "0", "1: what rays see that meet nothing"},
    {"texture", ParamType::text, "", "checker, cloud, testmap or image, in place of the colour"},
    {"a", ParamType::colour, "1", "of a checker"},
    {"b", ParamType::colour, "0", "of a checker"},
    {"scale", ParamType::number, "2", "fields of a checker across"},
    {"threshold", ParamType::number, "0.35", "where clouds begin"},
    {"range", ParamType::number, "0.3", "from the thinnest to the thickest cloud"},
    {"file", ParamType::text, "", "of an image: red, green, blue, a byte each, lowest row first"},
    {"width", ParamType::number, "512", "of the image [pixels]"},
    {"height", ParamType::number, "512", "of the image [pixels]"},
    {"repeat", ParamType::vector, "[1, 1]", "of the image across u and v"},
    {"chart", ParamType::vector, "[0]", "the primitive's own coordinates: kind and its numbers"},
    {"angle", ParamType::number, "180", "degrees around straight down that the light shines into"},
    {"light", ParamType::number, "0", "weight of the light this region is"},
    {"shadows", ParamType::number, "1", "0: that light has none"},
    {"place", ParamType::vector, "[0, 0, 0]", "where that light is"}};

std::shared_ptr<const RtTexture> texture_of(const Params& given) {
    static const std::map<std::string, RtTexture::Kind> kinds{{"checker", RtTexture::Kind::checker},
                                                              {"cloud", RtTexture::Kind::cloud},
                                                              {"testmap", RtTexture::Kind::testmap},
                                                              {"image", RtTexture::Kind::image}};
    const std::string name = given.text("texture");
    if (name.empty()) return nullptr;
    const auto kind = kinds.find(name);
    if (kind == kinds.end()) given.wrong("texture", "checker, cloud, testmap or image");
    auto out = std::make_shared<RtTexture>();
    out->kind = kind->second;
    out->a = given.colour("a", Rgb(1), 0, 1), out->b = given.colour("b", Rgb(0), 0, 1);
    out->scale = given.number("scale", 2, 0, 1e6);
    out->threshold = given.number("threshold", 0.35, -1e6, 1e6);
    out->range = given.number("range", 0.3, 1e-6, 1e6);
    out->width = static_cast<std::size_t>(given.number("width", 512, 1, most_pixels));
    out->height = static_cast<std::size_t>(given.number("height", 512, 1, most_pixels));
    if (const auto r = given.vector("repeat", 2)) out->repeat_u = (*r)[0], out->repeat_v = (*r)[1];
    // rt shows u and v where the picture is missing.
    if (out->kind == RtTexture::Kind::image && !out->load(given.text("file"))) out->kind = RtTexture::Kind::testmap;
    return out;
}

UvChart chart_of(const Params& given) {
    for (const auto& [name, value] : given.all())
        if (name == "chart") return UvChart(value.numbers);
    return {};
}

std::shared_ptr<const Shader> make(const ShaderInputs& in) {
    const auto number = [&](const char* name, double fallback, double most) {
        return static_cast<float>(in.params.number(name, fallback, 0, most));
    };
    RtFinish finish;
    finish.colour = in.params.colour("colour", Rgb(1), 0, 1);
    finish.shine = number("shine", 10, 1e6);
    finish.specular = number("specular", 0.7, 100);
    finish.diffuse = number("diffuse", 0.3, 100);
    finish.transmit = number("transmit", 0, 1);
    finish.reflect = number("reflect", 0, 1);
    finish.index = number("index", 1, 10);
    finish.flat = number("flat", 0, 1) > 0;
    finish.around = number("around", 0, 1) > 0;
    finish.texture = texture_of(in.params);
    finish.chart = chart_of(in.params);
    finish.beam_cosine = std::cos(number("angle", 180, 180) * (pi / 180));
    finish.light = number("light", 0, 1e6);
    finish.shadows = number("shadows", 1, 1) > 0;
    if (const auto p = in.params.vector("place", 3)) finish.place = {(*p)[0], (*p)[1], (*p)[2]};
    return std::make_shared<RtSurface>(finish);
}

}  // namespace

const Bsdf* RtSurface::bsdf(const SurfacePoint&, BsdfMemory& memory) const noexcept {
    return memory.make<MattBsdf>(finish_.colour * 0.8F);
}

const ShaderKind rt_surface_kind{"rt_surface", "surface of BRL-CAD's rt, for comparing with it", params, make};

}  // namespace cardioid::formats::brlcad
