#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "rt_core/image/compare/picture.hpp"

namespace cardioid::test {

/// What a program that ran to its end needed.
struct Run {
    int status = -1;
    double user_s = 0;  ///< processor time in its own code
    std::string messages;
};

/// Runs a program with these words, found by PATH, in the folder. Its output is caught.
Run run(const std::vector<std::string>& words, const std::filesystem::path& folder);

/// Whether `povray` is there.
bool has_povray();

/// POV-Ray's picture of a scene, one sample in the middle of each pixel, one thread, linear EXR; from the cache where
/// the same text has been drawn before.
struct PovPicture {
    Picture picture;
    double user_s = 0;
    std::filesystem::path file;
};
PovPicture draw_by_povray(const std::string& sdl, int width, int height);

}  // namespace cardioid::test
