#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "rt_core/image/compare/compare.hpp"

namespace cardioid::cli {

/// A figure that may be limited: the option is --max-NAME.
struct LimitKind {
    const char* name;
    const char* help;
    double (*value)(const RegionFigures&);
    bool every_region;  ///< holds for each region, not only for the whole
};
const std::vector<LimitKind>& limit_kinds();

/// What `compare` was asked.
struct CompareOptions {
    std::string a, b;  ///< files
    std::string limits_file, report, json;
    bool quiet = false;
    std::map<std::string, double> limits;  ///< by LimitKind::name
    CompareSettings settings;
    int grid = 0;  ///< regions by rows and columns
};

/// The options of the command, those of --limits read too; the command line wins. Nothing where help was asked for.
/// Throws Error(usage), Error(bad_input) for a file of limits that cannot be understood.
std::optional<CompareOptions> parse_compare_options(const std::vector<std::string>& words);

/// N x N regions of nearly equal size, named by row and column.
std::vector<PictureRegion> grid_regions(int n, int width, int height);

}  // namespace cardioid::cli
