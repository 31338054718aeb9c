#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fmt/format.h>

#include "cli/commands/commands.hpp"
#include "cli/compare/compare_options.hpp"
#include "cli/compare/verdict.hpp"
#include "cli/io/text_output.hpp"
#include "rt_core/api/error.hpp"

namespace cardioid::cli {
namespace {

/// The page's file in a folder that is made where it is missing. Throws Error(io).
std::string page_path(const std::string& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) throw Error(ErrorCode::io, fmt::format("{}: cannot make the folder: {}", folder, error.message()));
    std::string path = (std::filesystem::path(folder) / "index.html").string();
    check_text_path(path);
    return path;
}

}  // namespace

int run_compare(const std::vector<std::string>& words) {
    std::optional<CompareOptions> options = parse_compare_options(words);
    if (!options) return 0;
    if (!options->json.empty()) check_text_path(options->json);
    const std::string page = options->report.empty() ? "" : page_path(options->report);
    const Picture a = read_picture(options->a), b = read_picture(options->b);
    if (const std::string why = mismatch(a, b); !why.empty()) throw Error(ErrorCode::unequal, why);
    for (PictureRegion& region : grid_regions(options->grid, a.width, a.height))
        options->settings.regions.push_back(std::move(region));

    const Comparison comparison = compare(a, b, options->settings);
    const Verdict verdict = judge(comparison, *options);
    if (!options->json.empty()) write_text(options->json, comparison_json(comparison, verdict, *options));
    if (!page.empty()) write_text(page, report_page(a, b, comparison, verdict, *options));
    if (!options->quiet && options->json != "-") print_text(comparison_text(comparison, verdict));
    return verdict.good ? 0 : static_cast<int>(ErrorCode::unequal);
}

}  // namespace cardioid::cli
