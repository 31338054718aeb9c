#pragma once
#include <string>

namespace cardioid::cli {

/// Throws Error(io) now rather than after long work where `path` cannot be written. "-" is standard output.
void check_text_path(const std::string& path);

/// Writes the file whole or not at all; "-" is standard output. Throws Error(io).
void write_text(const std::string& path, const std::string& text);

/// Prints to standard output; throws Error(io) where it is full or closed.
void print_text(const std::string& text);

}  // namespace cardioid::cli
