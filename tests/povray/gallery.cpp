#include "tests/povray/gallery.hpp"

#include <algorithm>
#include <cmath>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sys/file.h>
#include <unistd.h>

#include "rt_core/image/atomic_file.hpp"
#include "rt_core/image/image_file.hpp"
#include "tests/povray/twin.hpp"

namespace cardioid::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

const fs::path folder = CARDIOID_POVRAY_REPORT;

constexpr const char* head = R"(<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<title>Cardioid and POV-Ray</title><style>
:root { color-scheme: light dark; --ink: #1c1f24; --paper: #f6f6f4; --line: #d0d0cc; --soft: #6a6f78; --good: #1d7f3f; --bad: #b3261e; }
@media (prefers-color-scheme: dark) { :root { --ink: #e8e8e6; --paper: #17191c; --line: #3a3e45; --soft: #9aa0aa; --good: #5cc481; --bad: #ff8a80; } }
body { margin: 0 auto; max-width: 76rem; padding: 1.2rem; background: var(--paper); color: var(--ink); font: 15px/1.45 system-ui, sans-serif; }
h1 { font-size: 1.3rem; } h2 { font-size: 1.1rem; margin-top: 2rem; } a { color: inherit; }
.good { color: var(--good); font-weight: 600; } .bad { color: var(--bad); font-weight: 600; } .soft { color: var(--soft); }
.cards { display: grid; grid-template-columns: repeat(auto-fill, minmax(21rem, 1fr)); gap: 1rem; }
.card { border: 1px solid var(--line); border-radius: .5rem; padding: .7rem; }
.card h3 { margin: 0 0 .3rem; font-size: 1rem; } .card p { margin: .3rem 0; }
.pair { display: flex; gap: 2px; } .pair img { width: 50%; image-rendering: pixelated; }
.wide { overflow-x: auto; } table { border-collapse: collapse; font-variant-numeric: tabular-nums; }
th, td { text-align: right; padding: .2rem .7rem; border-bottom: 1px solid var(--line); } th:first-child, td:first-child { text-align: left; }
</style></head><body><h1>Cardioid (left) and POV-Ray 3.7 (right)</h1>
)";

Json to_json(const Entry& e) {
    return {{"name", e.name},     {"proves", e.proves}, {"good", e.good},         {"verdict", e.verdict},
            {"beyond", e.beyond}, {"bias", e.bias},     {"flip", e.flip},         {"silhouette", e.silhouette},
            {"caught", e.caught}, {"our_s", e.our_s},   {"povray_s", e.povray_s}, {"our_render_s", e.our_render_s},
            {"size", e.size},     {"direct", e.direct}};
}

std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) out += c == '<' ? "&lt;" : c == '&' ? "&amp;" : std::string(1, c);
    return out;
}

std::string share_text(double share) {
    return share < 1e-5 ? "less than 0.001 %" : fmt::format("{:.2g} %", 100 * share);
}

std::string card(const Json& e) {
    std::string caught;
    for (const std::string mistake : e.at("caught")) caught += (caught.empty() ? "" : ", ") + mistake;
    const int outline = e.at("silhouette");
    const bool good = e.at("good");
    return fmt::format(
        "<div class=\"card\"><h3><a href=\"{0}/index.html\">{0}</a> <span class=\"{1}\">{2}</span></h3>"
        "<a class=\"pair\" href=\"{0}/index.html\"><img src=\"{0}/ours.png\" alt=\"ours\"><img src=\"{0}/povray.png\" "
        "alt=\"POV-Ray\"></a><p>{3}</p><p class=\"soft\">{4:.3g} % of pixels beyond 1e-3, means differ by {5}, "
        "FLIP "
        "{6:.2g}{7}. Seen as wrong: {8}.</p></div>\n",
        e.at("name").get<std::string>(), good ? "good" : "bad", good ? "within its limits" : escaped(e.at("verdict")),
        escaped(e.at("proves")), 100 * e.at("beyond").get<double>(), share_text(std::abs(e.at("bias").get<double>())),
        e.at("flip").get<double>(), outline < 0 ? "" : fmt::format(", {} pixels of outline differ", outline), caught);
}

std::string speed_row(const Json& e) {
    const double ours = e.at("our_s"), render = e.at("our_render_s"), theirs = e.at("povray_s");
    const auto times = [&](double s) {
        const double n = s > 0 ? theirs / s : 0;
        return fmt::format("<td class=\"{}\">{:.1f}</td>", n >= 3 ? "good" : "soft", n);
    };
    return fmt::format("<tr><td>{}</td><td>{}</td><td>{:.3f}</td><td>{:.3f}</td><td>{:.3f}</td>{}{}</tr>\n",
                       e.at("name").get<std::string>(), e.at("size").get<std::string>(), theirs, ours, render,
                       times(ours), times(render));
}

/// How the scenes with direct light stand against the goal; `key`: whose seconds.
std::string standing(const std::vector<Json>& entries, const char* key) {
    std::vector<double> times;
    for (const Json& e : entries)
        if (e.at("direct") && e.at(key) > 0) times.push_back(e.at("povray_s").get<double>() / e.at(key).get<double>());
    if (times.empty()) return "none";
    std::sort(times.begin(), times.end());
    const auto good = std::count_if(times.begin(), times.end(), [](double n) { return n >= 3; });
    return fmt::format("{} of {} at least three times as fast, median {:.2g}, from {:.2g} to {:.2g}", good,
                       times.size(), times[times.size() / 2], times.front(), times.back());
}

std::string speed_table(const std::vector<Json>& entries) {
    std::string text = fmt::format(
        "<h2>Speed</h2><p>Seconds of user processor time, one thread, on whatever else the machine did. The whole run "
        "counts start, reading and writing. Direct light is drawn with one sample a pixel by both, lens with 64 and "
        "128; Cornell box and caustics with each one's photons, not to equal error: docs/povray.md has that. Where we "
        "are less than three times as fast the figure is grey.</p><p>Scenes with direct light, our rendering against "
        "the whole of POV-Ray: {}. The whole programs: {}. The goal is three times for every one of them. "
        "The whole program loads OpenImageIO with its 250 libraries, 0.1 s whatever the picture; POV-Ray's start "
        "takes 0.01 s.</p>",
        standing(entries, "our_render_s"), standing(entries, "our_s"));
    text +=
        "<div class=\"wide\"><table><tr><th>scene</th><th>pixels</th><th>POV-Ray, whole</th><th>Cardioid, "
        "whole</th><th>its rendering</th><th>times as fast, whole</th><th>rendering against whole</th></tr>\n";
    for (const Json& e : entries) text += speed_row(e);
    return text + "</table></div>";
}

/// An 8-bit picture for the index; both as bright as the reference's brighter pixels allow.
void write_thumbnail(const fs::path& path, const Picture& picture, double exposure) {
    Film film{picture.width, picture.height, {{"", 3, {}}}};
    for (const Rgb& p : picture.pixels) film.layers[0].pixels.insert(film.layers[0].pixels.end(), {p.r, p.g, p.b});
    ImageWriteSettings settings;
    settings.exposure = exposure;
    write_image(path.string(), film, settings);
}

void write(const fs::path& path, const std::string& text) {
    write_whole_file(path.string(), std::as_bytes(std::span(text)));
}

/// Holds a file's lock: tests run two at a time, and each writes the index.
class Lock {
public:
    explicit Lock(const fs::path& path) : file_(open(path.c_str(), O_RDWR | O_CREAT, 0600)) { flock(file_, LOCK_EX); }
    ~Lock() { close(file_); }
    Lock(const Lock&) = delete;
    Lock& operator=(const Lock&) = delete;

private:
    int file_;
};

void write_index() {
    std::vector<Json> entries;
    for (const std::string& name : twin_names())
        if (std::ifstream file(folder / name / "entry.json"); file)
            // One that an older build has left behind may lack what is shown now.
            if (Json entry = Json::parse(file, nullptr, false); entry.contains("direct"))
                entries.push_back(std::move(entry));
    const auto good =
        std::count_if(entries.begin(), entries.end(), [](const Json& e) { return e.at("good").get<bool>(); });
    std::string page = head;
    page += fmt::format("<p class=\"{}\">{} of {} scenes are within their limits.</p>\n<div class=\"cards\">\n",
                        good == static_cast<std::ptrdiff_t>(entries.size()) ? "good" : "bad", good, entries.size());
    for (const Json& e : entries) page += card(e);
    page +=
        "</div>\n<h2>What is POV-Ray's own</h2><p>Its area_light darkens half shadows (its issue 224); its photons "
        "spread "
        "over thin walls, as behind the ring; its radiosity leaks at corners (issue 249) and leaves the ceiling of the "
        "Cornell box 3 % too dark. docs/povray.md tells what was measured.</p>\n";
    write(folder / "index.html", page + speed_table(entries) + "</body></html>\n");
}

}  // namespace

std::string report_folder() { return folder.string(); }

void add_to_gallery(const Entry& entry, const Picture& ours, const Picture& povray) {
    const fs::path place = folder / entry.name;
    fs::create_directories(place);
    std::vector<float> brightness;
    for (const Rgb& p : povray.pixels) brightness.push_back(max_component(p));
    // A lamp in the picture would make all else dark, so the brightest twentieth is left out.
    const auto bright = brightness.begin() + static_cast<std::ptrdiff_t>(brightness.size() * 19 / 20);
    std::nth_element(brightness.begin(), bright, brightness.end());
    const double exposure = *bright > 0 ? -std::log2(double{*bright}) : 0;
    write_thumbnail(place / "ours.png", ours, exposure);
    write_thumbnail(place / "povray.png", povray, exposure);
    const Lock lock(folder / "lock");
    write(place / "entry.json", to_json(entry).dump(2) + "\n");
    write_index();
}

}  // namespace cardioid::test
