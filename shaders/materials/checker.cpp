/// `checker`: fields of two colours or two other materials, cubes that fill space.
///
///     define_material("floor", kind = "checker", a = 0.8, b = [0.1, 0.1, 0.2], size = 10)
///     define_material("board", kind = "checker", a = "marble", b = "slate")
///
/// | parameter | default | |
/// |-----------|---------|---|
/// | `a`, `b`  | 0.8, 0.2 | a reflectance (diffuse) or the name of a material; light must not enter it |
/// | `size`    | 1       | edge of a field [scene units], above 0 |
///
/// The field of p is a where floor(x/size) + floor(y/size) + floor(z/size) is even, with the origin of the world at a
/// corner of a field. p is taken a little inside the solid (size/10000 against the normal), so that a face that lies on
/// a border of fields shows those inside the solid and does not flicker with rounding.
#include <cmath>

#include "shaders/materials/diffuse.hpp"
#include "shaders/materials/materials.hpp"

namespace cardioid::shaders {
namespace {

class CheckerShader final : public Shader {
public:
    CheckerShader(std::shared_ptr<const Shader> a, std::shared_ptr<const Shader> b, double size)
        : a_(std::move(a)), b_(std::move(b)), size_(size) {}

    [[nodiscard]] const Bsdf* bsdf(const SurfacePoint& hit, BsdfMemory& memory) const noexcept override {
        return field(hit).bsdf(hit, memory);
    }
    [[nodiscard]] Rgb emission(const SurfacePoint& hit, Vec3 wo) const noexcept override {
        return field(hit).emission(hit, wo);
    }
    [[nodiscard]] const Medium* interior() const noexcept override {
        const Medium* first = a_->interior();
        return first ? first : b_->interior();
    }
    [[nodiscard]] Rgb straight_transmittance(const SurfacePoint& hit, Vec3 wo) const noexcept override {
        return field(hit).straight_transmittance(hit, wo);
    }
    [[nodiscard]] bool filters() const noexcept override { return a_->filters() || b_->filters(); }

private:
    [[nodiscard]] const Shader& field(const SurfacePoint& hit) const noexcept {
        const Vec3d q = hit.p / size_ - Vec3d(hit.ng) * 1e-4;
        // Sums of whole numbers are exact in double far beyond any scene.
        const double sum = std::floor(q.x) + std::floor(q.y) + std::floor(q.z);
        return std::fmod(sum, 2) == 0 ? *a_ : *b_;
    }

    std::shared_ptr<const Shader> a_, b_;
    double size_;
};

constexpr ParamSpec params[] = {
    {"a", ParamType::colour, "0.8", "reflectance of one field, 0 to 1, or the name of a material in quotes"},
    {"b", ParamType::colour, "0.2", "the other field"},
    {"size", ParamType::number, "1", "edge of a field [scene units], above 0"}};

std::shared_ptr<const Shader> read_field(const ShaderInputs& in, const char* name, float fallback) {
    if (!in.params.is_text(name)) return std::make_shared<DiffuseShader>(in.params.colour(name, Rgb(fallback), 0, 1));
    const std::string material = in.params.text(name);
    if (!in.find_material) in.params.wrong(name, "a colour");
    std::shared_ptr<const Shader> shader = in.find_material(material);
    if (!shader) in.params.wrong(name, "the name of a material; there is no \"" + material + "\"");
    // A solid has one filling, so its fields cannot differ in what is behind them; a thin film (index 1) has none.
    if (const Medium* medium = shader->interior(); medium && !(*medium == Medium{}))
        in.params.wrong(name, "a material that light does not enter, not \"" + material + "\"");
    return shader;
}

std::shared_ptr<const Shader> make(const ShaderInputs& in) {
    const double size = in.params.number("size", 1, 0);
    if (size <= 0) in.params.wrong("size", "above 0");
    return std::make_shared<CheckerShader>(read_field(in, "a", 0.8F), read_field(in, "b", 0.2F), size);
}

}  // namespace

const ShaderKind checker_kind{"checker", "cubes of two colours or materials that fill space", params, make};

}  // namespace cardioid::shaders
