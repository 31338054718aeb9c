#pragma once

namespace cardioid::cli {

/// share/compare_report.html, put into the program by the build.
extern const char* const report_template;

}  // namespace cardioid::cli
