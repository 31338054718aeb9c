#include "formats/openscad/evaluate/settings.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "formats/openscad/geometry/transforms.hpp"
#include "rt_core/scene/nearest_name.hpp"

namespace cardioid::formats::openscad {
namespace {

/// A whole number from 1 to a billion, which the renderer's own limits then judge.
int count(const Arguments& args, double x, const char* what) {
    constexpr double most = 1e9;
    if (!(x >= 1 && x <= most) || x != std::floor(x))
        args.fail(std::string(what) + " must be a whole number from 1 on");
    return static_cast<int>(x);
}

Vec3d place(const Arguments& args, const char* name, Vec3d fallback) {
    if (!args.has(name)) return fallback;
    const auto xs = *args.numbers(name, 3);
    const Vec3d out{xs[0], xs[1], xs[2]};
    if (xs.size() != 3 || !is_finite(out)) args.wrong(name, "three finite numbers [x, y, z]");
    return out;
}

double within(const Arguments& args, const char* name, double fallback, double lo, double hi, const char* wanted) {
    const double x = args.number(name, fallback);
    if (!std::isfinite(x) || x < lo || x > hi) args.wrong(name, wanted);
    return x;
}

/// How much a map lengthens, for radii: the cube root of its determinant.
double mean_scale(const Affine& m) { return std::cbrt(std::abs(m.determinant())); }

void read_projection(const Arguments& args, const Affine& to_world, CameraSettings& out) {
    static constexpr std::string_view known[] = {"perspective", "orthographic"};
    const std::string name = args.has("projection") ? args.text("projection") : "perspective";
    if (name != known[0] && name != known[1])
        args.wrong("projection", "\"perspective\" or \"orthographic\"" + did_you_mean(name, known));
    if (name == known[0]) return;
    out.projection = CameraSettings::Projection::orthographic;
    out.width = within(args, "width", 0, 0, HUGE_VAL, "a finite width [units]") * mean_scale(to_world);
    if (!(out.width > 0)) args.wrong("width", "above 0 for an orthographic camera");
}

}  // namespace

const LightKind* find_light(const Registry* registry, std::string_view name) {
    if (!registry) return nullptr;
    for (const LightKind& kind : registry->lights())
        if (name == kind.name) return &kind;
    return nullptr;
}

FilmSettings read_film(const Arguments& args) {
    FilmSettings out;
    if (args.has("size")) {
        const auto xs = *args.numbers("size", 2);
        if (xs.size() != 2) args.wrong("size", "[width, height]");
        out.width = count(args, xs[0], "the width of film()");
        out.height = count(args, xs[1], "the height of film()");
    }
    if (const auto n = args.number("samples")) out.samples = count(args, *n, "samples of film()");
    out.exposure = within(args, "exposure", 0, -100, 100, "a number of stops from -100 to 100");
    return out;
}

CameraSettings read_camera(const Arguments& args, const Affine& to_world, Warnings& warnings) {
    CameraSettings out;
    if (is_singular(to_world)) args.fail("camera() stands in a transform that flattens it");
    if (args.has("name")) out.name = args.text("name");
    const Vec3d eye = place(args, "eye", out.eye), look_at = place(args, "look_at", out.look_at);
    const Vec3d up = place(args, "up", out.up);
    if (eye == look_at) args.fail("camera() looks at where it stands, wanted another look_at");
    if (length(up) == 0) args.wrong("up", "a direction, not [0, 0, 0]");
    out.eye = to_world.point(eye);
    out.look_at = to_world.point(look_at);
    out.up = to_world.vector(up);
    out.fov_deg = within(args, "fov", out.fov_deg, 1e-6, 179.999, "an angle in degrees above 0 and below 180");
    if (args.has("fov_axis")) {
        const std::string axis = args.text("fov_axis");
        if (axis != "x" && axis != "y") args.wrong("fov_axis", "\"x\" or \"y\"");
        out.fov_is_horizontal = axis == "x";
    }
    out.lens_radius = within(args, "lens_radius", 0, 0, HUGE_VAL, "a radius of at least 0") * mean_scale(to_world);
    out.focus = within(args, "focus", 0, 0, HUGE_VAL, "a distance of at least 0") * mean_scale(to_world);
    read_projection(args, to_world, out);
    if (args.has("shutter"))
        warnings.once("shutter", args.where(), "shutter has no effect: nothing moves, animate() is not supported yet");
    return out;
}

LightSettings read_light(const LightKind& kind, const Ast& ast, const Call& call, const Affine& to_world,
                         Warnings& warnings) {
    std::vector<std::string_view> names;
    for (const ParamSpec& spec : kind.params) names.emplace_back(spec.name);
    const Arguments args(ast, call, {names, {}, false}, warnings);
    if (is_singular(to_world)) args.fail(std::string(kind.name) + "() stands in a transform that flattens it");
    return {kind.name, args.params(), to_world};
}

Params read_photons(const Ast& ast, const Call& call) {
    Params out(ast.where(call.place));
    for (const Argument& argument : ast.arguments_of(call)) {
        if (argument.name == Argument::no_name) continue;
        if (auto value = param_value(ast, argument.value)) out.set(ast.texts[argument.name], std::move(*value));
    }
    return out;
}

void map_colour(const Arguments& args, MaterialTable& materials) {
    Rgba rgba{0, 0, 0, 1};
    const auto xs = args.numbers("color", 3);
    if (!xs || !args.has("material")) args.fail("found too little, wanted map_color([r, g, b, a], \"material\")");
    std::copy_n(xs->begin(), std::min<std::size_t>(xs->size(), 4), rgba.begin());
    for (double& x : rgba) x = std::isfinite(x) ? std::clamp(x, 0.0, 1.0) : 0;
    materials.map_colour(rgba, args.text("material"), args.where());
}

}  // namespace cardioid::formats::openscad
