#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "rt_core/api/math.hpp"

namespace cardioid::formats::povray {

/// A number of POV-Ray's scene description language with all digits that doubles need; -0 is 0.
std::string sdl(double x);
/// `<x, y, z>`.
std::string sdl(Vec3d v);
/// `rgb <r, g, b>`, or `rgb g` for grey; with the digits that floats need.
std::string sdl(Rgb c);
/// A colour divided by pi: POV-Ray's lights are intensities of which a white surface sends back all, not 1/pi of it.
std::string sdl_over_pi(Rgb c, double times = 1);
/// `matrix <...>` that does what the map does.
std::string sdl(const Affine& map);

/// A name that may be declared: letters, digits and `_` of `name` behind a prefix, no two alike.
class Identifiers {
public:
    std::string make(std::string_view prefix, std::string_view name);

private:
    std::vector<std::string> taken_;
};

/// What the scene says and POV-Ray cannot, in the order it was found, each once.
class Notes {
public:
    void add(const std::string& where, const std::string& text);
    [[nodiscard]] const std::vector<std::string>& all() const { return all_; }

private:
    std::vector<std::string> all_;
};

}  // namespace cardioid::formats::povray
