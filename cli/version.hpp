#pragma once
#include <string>

namespace cardioid::cli {

/// "0.1.0".
std::string version();

/// The text of --version: this program, its plug-in ABI, the libraries it is built with, and whether openscad is there.
std::string version_text();

}  // namespace cardioid::cli
