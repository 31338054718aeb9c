#pragma once
#include <string>
#include <vector>

#include "cli/compare/verdict.hpp"

namespace cardioid::test {

/// What became of a scene, for the page that shows them all.
struct Entry {
    std::string name, proves;
    bool good = false;
    std::string verdict;
    double beyond = 0, bias = 0, flip = 0;
    int silhouette = -1;              ///< pixels by which outlines differ, -1: not looked at
    std::vector<std::string> caught;  ///< mistakes that were found
    std::string size;                 ///< of the pictures that were timed
    bool direct = true;               ///< drawn without photons
    double our_s = 0, povray_s = 0;   ///< user processor time of the whole run
    double our_render_s = 0;          ///< of it, of the rendering alone
};

/// Where the pages go.
std::string report_folder();

/// Writes the entry beside its page, and index.html anew from all entries that are there: tests run one by one.
void add_to_gallery(const Entry& entry, const Picture& ours, const Picture& povray);

}  // namespace cardioid::test
