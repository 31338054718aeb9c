#include "cli/commands/render_report.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/resource.h>

#include "cli/commands/energy_report.hpp"
#include "cli/version.hpp"
#include "csg/region/weld_counts.hpp"

namespace cardioid::cli {
namespace {

using Json = nlohmann::ordered_json;

std::string scene_hash(const RenderReport& report) { return fmt::format("{:016x}", report.committed.hash()); }

Json versions() {
    return {{"cardioid", version()},
            {"embree", CARDIOID_EMBREE_VERSION},
            {"openimageio", CARDIOID_OPENIMAGEIO_VERSION},
            {"cgal", CARDIOID_CGAL_VERSION}};
}

Json picture(const RenderReport& report) {
    const RenderSettings& s = report.settings;
    Json json{{"file", report.options.output},        {"width", s.width}, {"height", s.height},
              {"samples", report.statistics.samples}, {"seed", s.seed},   {"lighting", report.lighting.name}};
    if (s.noise > 0) json["noise"] = report.statistics.noise;
    return json;
}

Json scene(const RenderReport& report) {
    const TracerMemory memory = report.committed.tracer().memory();
    return {{"file", report.scene.file},
            {"hash", scene_hash(report)},
            {"solids", report.committed.tracer().regions().size()},
            {"leaves", memory.leaves},
            {"triangles", memory.triangle_count},
            {"materials", report.scene.materials.size()},
            {"lights", report.committed.lights().size()},
            {"warnings", report.scene.warnings.size() + report.committed.warnings().size()}};
}

/// Bytes; and a leaf's share, a triangle's share over Embree's own.
Json memory(const RenderReport& report) {
    const TracerMemory m = report.committed.tracer().memory();
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    Json json{{"solids", m.regions}, {"embree", m.embree}, {"triangles", m.triangles}};
    if (m.leaves > 0) json["bytes_a_leaf"] = static_cast<double>(m.regions) / static_cast<double>(m.leaves);
    if (m.triangle_count > 0)
        json["bytes_a_triangle"] = static_cast<double>(m.embree + m.triangles) / static_cast<double>(m.triangle_count);
    json["peak"] = static_cast<std::int64_t>(usage.ru_maxrss) * 1024;
    return json;
}

Json rays(const RenderStatistics& s) {
    const std::uint64_t all = s.camera_rays + s.shadow_rays + s.specular_rays + s.bounce_rays;
    Json json{{"camera", s.camera_rays},
              {"shadow", s.shadow_rays},
              {"specular", s.specular_rays},
              {"bounce", s.bounce_rays},
              {"all", all}};
    if (s.cpu_seconds > 0) json["all_a_cpu_second"] = static_cast<double>(all) / s.cpu_seconds;
    return json;
}

/// Crossings of rays with faces that coincide: at one place, or within what six digits tell.
Json coincident_faces() {
    const csg::WeldCounts counts = csg::weld_counts();
    return {{"exact", counts.exact}, {"welded", counts.welded}};
}

Json bad_samples(const RenderStatistics& s) {
    Json json{{"count", s.bad_samples}};
    if (s.bad_samples > 0) json["first_pixel"] = {s.first_bad_pixel[0], s.first_bad_pixel[1]};
    return json;
}

Json lighting(const RenderReport& report) {
    Json json = Json::object();
    for (const auto& [name, value] : report.module.statistics())
        std::visit([&, &key = name](const auto& v) { json[key] = v; }, value);
    return json;
}

}  // namespace

Metadata picture_metadata(const RenderReport& report) {
    return {{"Software", "Cardioid " + version()},
            {"CommandLine", report.command},
            {"Seed", std::to_string(report.settings.seed)},
            {"SceneHash", scene_hash(report)},
            {"Samples", std::to_string(report.statistics.samples)}};
}

std::string statistics_json(const RenderReport& report) {
    const RenderStatistics& s = report.statistics;
    Json seconds = Json::object();
    for (const auto& [phase, time] : report.phases_s) seconds[phase] = time;
    seconds["render_cpu"] = s.cpu_seconds;
    Json json{{"versions", versions()},
              {"command", report.command},
              {"interrupted", s.interrupted},
              {"picture", picture(report)},
              {"scene", scene(report)},
              {"memory_bytes", memory(report)},
              {"seconds", seconds},
              {"rays", rays(s)},
              {"bad_samples", bad_samples(s)},
              {"lighting", lighting(report)},
              {"coincident_faces", coincident_faces()}};
    if (report.energy) json["energy_W"] = energy_json(*report.energy);
    // A file name need not be UTF-8; JSON must.
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::vector<std::string> statistics_lines(const RenderReport& report) {
    const RenderStatistics& s = report.statistics;
    const TracerMemory m = report.committed.tracer().memory();
    std::vector<std::string> lines;
    lines.push_back(fmt::format("scene {}: {} solids of {} leaves, {} triangles, {} lights", scene_hash(report),
                                report.committed.tracer().regions().size(), m.leaves, m.triangle_count,
                                report.committed.lights().size()));
    if (m.leaves > 0)
        lines.push_back(fmt::format("memory: {} bytes a leaf, Embree {:.1f} MB", m.regions / m.leaves,
                                    static_cast<double>(m.embree) / 1e6));
    std::string times = "seconds:";
    for (const auto& [phase, time] : report.phases_s) times += fmt::format(" {} {:.2f}", phase, time);
    lines.push_back(times);
    lines.push_back(fmt::format("rays: {} camera, {} shadow, {} specular, {} of bounces", s.camera_rays, s.shadow_rays,
                                s.specular_rays, s.bounce_rays));
    if (const csg::WeldCounts welds = csg::weld_counts(); welds.exact + welds.welded > 0)
        lines.push_back(fmt::format("coincident faces: {} crossings of faces at one place, {} of faces welded",
                                    welds.exact, welds.welded));
    for (const auto& [name, value] : report.module.statistics())
        std::visit([&, &key = name](const auto& v) { lines.push_back(fmt::format("{}: {}", key, v)); }, value);
    if (report.energy)
        for (std::string& line : energy_lines(*report.energy)) lines.push_back(std::move(line));
    return lines;
}

}  // namespace cardioid::cli
