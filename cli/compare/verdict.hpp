#pragma once
#include <string>
#include <vector>

#include "cli/compare/compare_options.hpp"

namespace cardioid::cli {

/// One limit held against one figure.
struct LimitCheck {
    std::string name;  ///< of the limit, with its region
    double found, allowed;
    [[nodiscard]] bool good() const { return found <= allowed; }
};

/// What was found, and whether it is good enough.
struct Verdict {
    std::vector<LimitCheck> checks;
    bool good = true;
    std::string text;  ///< one line
};

/// Without a limit nothing may differ. Pixels that are not finite are never good.
Verdict judge(const Comparison& comparison, const CompareOptions& options);

/// The figures as a table for people, and everything as JSON.
std::string comparison_text(const Comparison& comparison, const Verdict& verdict);
std::string comparison_json(const Comparison& comparison, const Verdict& verdict, const CompareOptions& options);

/// The page of --report, all in one text: both pictures, FLIP, figures.
std::string report_page(const Picture& a, const Picture& b, const Comparison& comparison, const Verdict& verdict,
                        const CompareOptions& options);

}  // namespace cardioid::cli
