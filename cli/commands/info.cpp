#include <fmt/format.h>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "cli/builtins.hpp"
#include "cli/commands/commands.hpp"
#include "cli/commands/describe.hpp"
#include "cli/commands/describe_map.hpp"
#include "cli/io/scene_input.hpp"
#include "cli/io/text_output.hpp"
#include "cli/terminal/console.hpp"
#include "cli/terminal/interrupt.hpp"
#include "csg/compile.hpp"
#include "csg/measure.hpp"
#include "csg/measure_area.hpp"
#include "csg/shapes/mesh_repair.hpp"
#include "formats/mesh/write/scene_meshes.hpp"
#include "photon/file/map_reader.hpp"
#include "rt_core/image/image_file.hpp"

namespace cardioid::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr int first_grid = 256, last_grid = 1024;  ///< lines a side
constexpr double good_share = 2e-3;                ///< standard error that is small enough, of the volume

/// More lines until the figure is sure enough, or enough time has gone into it.
csg::VolumeEstimate measure(const Region& region) {
    csg::VolumeEstimate estimate;
    for (int grid = first_grid; grid <= last_grid; grid *= 2) {
        estimate = csg::measure_volume(region, region.bounds(), grid, 0);
        if (estimate.sigma <= good_share * estimate.volume) break;
    }
    return estimate;
}

/// Infinity and NaN have no place in JSON.
Json number(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }
Json vector(Vec3d v) { return {number(v.x), number(v.y), number(v.z)}; }

/// What is told only where it is asked for.
struct Wishes {
    bool area = false, mesh = false;
};

/// The surface by random lines, until the figure is sure enough.
void add_area(const Region& whole, Json& json) {
    constexpr std::int64_t first = 1 << 16, last = 1 << 22;
    if (!whole.bounds().bounded()) {
        json["area"] = json["area_standard_error"] = nullptr;
        return;
    }
    csg::AreaEstimate estimate;
    for (std::int64_t lines = first; lines <= last; lines *= 4) {
        estimate = csg::measure_area(whole, whole.bounds(), lines, 0);
        if (estimate.sigma <= good_share * estimate.area) break;
    }
    json["area"] = estimate.area;
    json["area_standard_error"] = estimate.sigma;
}

/// Volume and surface of the exact mesh, which has no error but that of its chords; or why there is none. True for one.
bool add_mesh_figures(const Scene& scene, Json& json, Progress& progress) try {
    const TriangleMesh mesh = std::move(formats::scene_meshes(scene, {.one = true, .progress = &progress})[0].mesh);
    double area = 0;
    for (const auto& [a, b, c] : mesh.triangles)
        area += length(cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a])) / 2;
    json["mesh_volume"] = csg::volume(mesh);
    json["mesh_area"] = area;
    json["mesh_triangles"] = mesh.triangles.size();
    json["mesh_closed"] = mesh.closed;
    return true;
} catch (const Error& e) {
    if (e.code() == ErrorCode::interrupted) throw;
    json["mesh_refused"] = e.what();
    return false;
}

Json leaves_json(const SolidTree& tree) {
    std::map<LeafKind, std::size_t> counts;
    for (const Leaf& leaf : tree.leaves) ++counts[leaf.kind];
    Json json = Json::object();
    for (const auto& [kind, count] : counts) json[leaf_kind_name(kind)] = count;
    return json;
}

Json names_json(const Scene& scene) {
    Json materials = Json::array(), lights = Json::array(), cameras = Json::array();
    for (const MaterialSettings& m : scene.materials) materials.push_back({{"name", m.name}, {"kind", m.kind}});
    for (const LightSettings& l : scene.lights) lights.push_back(l.kind);
    for (const CameraSettings& c : scene.cameras)
        cameras.push_back({{"name", c.name}, {"eye", vector(c.eye)}, {"look_at", vector(c.look_at)}});
    return {{"materials", materials}, {"lights", lights}, {"cameras", cameras}};
}

Json scene_json(const Scene& scene, Wishes wishes, Progress& progress) {
    std::size_t triangles = 0;
    bool closed = true;
    for (const auto& mesh : scene.solids.meshes) triangles += mesh->triangles.size(), closed = closed && mesh->closed;
    Json json{{"file", scene.file},
              {"solids", scene.solids.roots.size()},
              {"leaves", leaves_json(scene.solids)},
              {"triangles", triangles},
              {"meshes_closed", closed}};
    for (const auto& [name, text] : scene.facts) json["facts"][name] = text;
    Json mesh = Json::object();
    // Rays tell the area, too, where no mesh does.
    if (wishes.mesh && !add_mesh_figures(scene, mesh, progress)) wishes.area = true;
    csg::VolumeEstimate volume;
    if (const auto whole = csg::compile_whole(scene.solids, scene.six_digits)) {
        const Box3d all = whole->bounds(), box = all.bounded() ? all : bounded_box(csg::compile(scene, {}));
        if (!box.empty()) json["bounds"] = {vector(box.lo), vector(box.hi)};
        volume = measure(*whole);
        if (wishes.area) add_area(*whole, json);
    }
    json.update(mesh);
    json["volume"] = number(volume.volume);
    json["volume_standard_error"] = volume.bounded() ? number(volume.sigma) : Json(nullptr);
    json.update(names_json(scene));
    json["warnings"] = scene.warnings;
    return json;
}

std::string joined(const Json& list, const std::string& none) {
    std::string text;
    for (const Json& item : list) text += (text.empty() ? "" : ", ") + item.get<std::string>();
    return text.empty() ? none : text;
}

std::string coordinates(const Json& v) {
    std::string text;
    for (const Json& x : v) text += fmt::format("{}{:.6g}", text.empty() ? "" : " ", x.get<double>());
    return text;
}

std::string geometry_text(const Json& json) {
    std::string leaves;
    for (const auto& [kind, count] : json["leaves"].items())
        leaves += fmt::format("{}{} {}", leaves.empty() ? "" : ", ", count.get<std::size_t>(), kind);
    std::string text = json["file"].get<std::string>() + "\n";
    if (json.contains("facts"))
        for (const auto& [name, fact] : json["facts"].items())
            text += fmt::format("{}: {}\n", name, fact.get<std::string>());
    text += fmt::format("solids: {} of {}\n", json["solids"].get<std::size_t>(), leaves.empty() ? "no leaves" : leaves);
    if (json["triangles"] > 0) text += fmt::format("triangles: {}\n", json["triangles"].get<std::size_t>());
    if (json.contains("bounds"))
        text += fmt::format("bounds: {} to {}{}\n", coordinates(json["bounds"][0]), coordinates(json["bounds"][1]),
                            json["volume"].is_null() ? ", of what is bounded" : "");
    if (json["volume"].is_null())
        text += "volume: unbounded\n";
    else
        text += fmt::format("volume: {:.8g} +- {:.2g}{}\n", json["volume"].get<double>(),
                            json["volume_standard_error"].get<double>(),
                            json["meshes_closed"] ? "" : " (means little: a mesh is not closed)");
    if (json.contains("area"))
        text += json["area"].is_null() ? "area: unbounded\n"
                                       : fmt::format("area: {:.8g} +- {:.2g}\n", json["area"].get<double>(),
                                                     json["area_standard_error"].get<double>());
    if (json.contains("mesh_refused"))
        text += fmt::format("exact mesh: none, volume and area are those by rays: {}\n",
                            json["mesh_refused"].get<std::string>());
    if (json.contains("mesh_volume"))
        text += fmt::format("exact mesh: volume {:.10g}, area {:.10g}, {} triangles{}\n",
                            json["mesh_volume"].get<double>(), json["mesh_area"].get<double>(),
                            json["mesh_triangles"].get<std::size_t>(), json["mesh_closed"] ? "" : ", not closed");
    return text;
}

std::string scene_text(const Json& json) {
    Json materials = Json::array(), cameras = Json::array();
    for (const Json& m : json["materials"])
        materials.push_back(fmt::format("{} ({})", m["name"].get<std::string>(), m["kind"].get<std::string>()));
    for (const Json& c : json["cameras"])
        cameras.push_back(fmt::format("{} from {} to {}", c["name"].get<std::string>(), coordinates(c["eye"]),
                                      coordinates(c["look_at"])));
    return geometry_text(json) + fmt::format("materials: {}\nlights: {}\ncameras: {}\n", joined(materials, "none"),
                                             joined(json["lights"], "none, so the studio's"),
                                             joined(cameras, "none, so a fitted one"));
}

Json image_json(const std::string& file) {
    Metadata metadata;
    const Film film = read_image(file, &metadata);
    Json layers = Json::array(), made = Json::object();
    for (const Layer& layer : film.layers) layers.push_back({{"name", layer.name}, {"channels", layer.channels}});
    for (const auto& [name, text] : metadata) made[name] = text;
    return {{"file", file}, {"width", film.width}, {"height", film.height}, {"layers", layers}, {"metadata", made}};
}

std::string image_text(const Json& json) {
    std::string text = fmt::format("{}\nsize: {}x{}\n", json["file"].get<std::string>(), json["width"].get<int>(),
                                   json["height"].get<int>());
    for (const Json& layer : json["layers"]) {
        const std::string name = layer["name"];
        text += fmt::format("layer: {} ({} channels)\n", name.empty() ? "beauty" : name, layer["channels"].get<int>());
    }
    for (const auto& [name, value] : json["metadata"].items())
        text += fmt::format("{}: {}\n", name, value.get<std::string>());
    return text;
}

/// The picture's figures, or nothing where the file is none.
std::optional<Json> try_image(const std::string& file) {
    try {
        return image_json(file);
    } catch (const Error&) {
        return std::nullopt;
    }
}

/// A file's figures and the same as text.
struct Report {
    Json json;
    std::string text;
};

Report report_on(const SceneOptions& options, const Wishes& wishes) {
    if (options.file != "-" && photon::is_map_file(options.file)) {
        Json json = map_json(options.file);
        return {json, map_text(json)};
    }
    const std::unique_ptr<Registry> registry = open_registry(options.plugins);
    const std::string content = read_text(options.file);
    if (!find_reader(options.file, content, *registry))
        if (std::optional<Json> image = try_image(options.file)) return {*image, image_text(*image)};
    const Scene scene = read_scene(options, content, *registry);
    Console console(Loudness::normal, progress_style("auto", Loudness::normal));
    for (const std::string& warning : scene.warnings) console.warn(warning);
    if (wishes.mesh) catch_interrupts();
    Json json = scene_json(scene, wishes, console);
    return {json, scene_text(json)};
}

}  // namespace

int run_info(const std::vector<std::string>& words) {
    SceneOptions options;
    Wishes wishes;
    std::string json_file;
    Arguments arguments("info SCENE|IMAGE|MAP [options]",
                        "Tells what is in a scene or a photon map, or made a picture.");
    arguments.text("--json", "FILE", "Write it as JSON; - is standard output, in place of the text", json_file);
    arguments.flag("--volume,--mesh", "Tell volume and area of the exact mesh, too, beside the volume by rays",
                   wishes.mesh);
    arguments.flag("--area", "Tell the area of the surface by random lines, too", wishes.area);
    add_scene_options(arguments, options, "SCENE|IMAGE|MAP");
    add_format_settings(arguments, options);
    if (!arguments.parse(words)) return 0;
    if (!json_file.empty()) check_text_path(json_file);

    const Report report = report_on(options, wishes);
    if (json_file != "-") print_text(report.text);
    if (!json_file.empty())
        write_text(json_file, report.json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
    return 0;
}

}  // namespace cardioid::cli
