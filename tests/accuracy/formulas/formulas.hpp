#pragma once
#include <span>
#include <string>
#include <utility>

namespace cardioid::test {

using Arguments = std::span<const double>;

/// A formula of the table by its name: what the values of samples/accuracy/expected.json were found by, computed anew.
/// Throws Error(usage) where there is none of that name, Error(bad_input) for another number of arguments.
double known_formula(const std::string& name, Arguments args);

/// A formula and how many arguments it takes.
struct Formula {
    const char* name;
    std::size_t arguments;
    double (*value)(Arguments);
};

/// A file each: diffuse light, smooth surfaces, materials, curved mirrors and lenses, skies.
std::span<const Formula> form_factor_formulas();
std::span<const Formula> interreflection_formulas();
std::span<const Formula> optics_formulas();
std::span<const Formula> material_formulas();
std::span<const Formula> caustic_formulas();
std::span<const Formula> sky_formulas();

/// Reflectances of a smooth surface across and within the plane of incidence, with eta the index beyond it over that on
/// this side (Fresnel); 1, 1 under total internal reflection.
std::pair<double, double> fresnel(double cosine, double eta);
/// Their mean.
double unpolarised(double cosine, double eta);

/// Mean of f(c) over even light: the integral of 2 c f(c) over c in [0, 1], by the midpoint rule.
template <class F>
double over_cosines(F&& f) {
    constexpr int n = 20'000;
    double sum = 0;
    for (int i = 0; i < n; ++i) sum += 2 * (i + 0.5) / n * f((i + 0.5) / n);
    return sum / n;
}

constexpr double degree = 0.017453292519943295;

}  // namespace cardioid::test
