#include "tests/accuracy/results.hpp"

#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "rt_core/image/atomic_file.hpp"

namespace cardioid::test {

namespace {

using Json = nlohmann::json;

/// FNV-1a, 64 bits.
std::uint64_t hash(const std::string& text) {
    std::uint64_t h = 0xcbf29ce484222325U;
    for (const char c : text) h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
    return h;
}

std::string text_of(const Vec3d& v) { return fmt::format("{} {} {} ", v.x, v.y, v.z); }

/// A number for all that a result depends on but the program.
std::string subject(const KnownValue& known, const std::string& module) {
    std::ifstream stream(CARDIOID_SOURCE_DIR "/samples/accuracy/" + known.scene);
    std::ostringstream all;
    all << stream.rdbuf();
    for (const auto& [from, to] : known.change) all << from << '\n' << to << '\n';
    const Place& place = known.place;
    all << fmt::format("{} {} {} {} {}", static_cast<int>(place.kind), static_cast<int>(place.what), place.radius,
                       place.side, known.tolerance(module));
    for (const Vec3d& v : {place.origin, place.u, place.v, place.along}) all << text_of(v);
    return fmt::format("{:016x}", hash(all.str()));
}

std::string key(const KnownValue& known, const std::string& module) { return module + ": " + known.title(); }

}  // namespace

Results::Results(std::string file) : file_(std::move(file)) {
    if (file_.empty() || !std::filesystem::exists(file_)) return;
    std::ifstream stream(file_);
    try {
        const Json all = Json::parse(stream);
        for (const auto& [name, one] : all.items()) {
            Measured found{
                .value = one.at("value"), .standard_error = one.at("standard_error"), .runs = one.at("runs")};
            found.samples = one.at("samples"), found.cpu_s = one.at("cpu_s"), found.bad_samples = one.at("bad_samples");
            kept_[name] = {one.at("of"), found};
        }
    } catch (const Json::exception& error) {
        throw Error(ErrorCode::bad_input, file_ + ": " + error.what());
    }
}

std::optional<Verdict> Results::find(const KnownValue& known, const std::string& module) const {
    std::optional<Verdict> verdict = any(known, module);
    if (verdict && !verdict->sure && !as_long_as_allowed(verdict->found, module)) verdict.reset();
    return verdict;
}

std::optional<Verdict> Results::any(const KnownValue& known, const std::string& module) const {
    const std::scoped_lock lock(mutex_);
    const auto at = kept_.find(key(known, module));
    if (at == kept_.end() || at->second.of != subject(known, module)) return std::nullopt;
    return verdict_of(known, module, at->second.found);
}

void Results::add(const KnownValue& known, const std::string& module, const Verdict& verdict) {
    const std::scoped_lock lock(mutex_);
    kept_[key(known, module)] = {subject(known, module), verdict.found};
    if (!file_.empty()) write();
}

void Results::write() const {
    Json all = Json::object();
    for (const auto& [name, one] : kept_)
        all[name] = {{"of", one.of},
                     {"value", one.found.value},
                     {"standard_error", one.found.standard_error},
                     {"runs", one.found.runs},
                     {"samples", one.found.samples},
                     {"cpu_s", one.found.cpu_s},
                     {"bad_samples", one.found.bad_samples}};
    const std::string text = all.dump(1) + "\n";
    write_whole_file(file_, std::as_bytes(std::span(text)));
}

}  // namespace cardioid::test
