#include "tests/accuracy/formulas/formulas.hpp"

#include <cmath>

#include "rt_core/api/error.hpp"

namespace cardioid::test {

double known_formula(const std::string& name, Arguments args) {
    for (const auto formulas : {form_factor_formulas(), interreflection_formulas(), optics_formulas(),
                                material_formulas(), caustic_formulas(), sky_formulas()})
        for (const Formula& formula : formulas)
            if (formula.name == name) {
                if (formula.arguments == args.size()) return formula.value(args);
                throw Error(ErrorCode::bad_input, name + " takes " + std::to_string(formula.arguments) + " arguments");
            }
    throw Error(ErrorCode::usage, "there is no formula " + name);
}

std::pair<double, double> fresnel(double cosine, double eta) {
    const double sine2 = (1 - cosine * cosine) / (eta * eta);
    if (sine2 >= 1) return {1, 1};
    const double t = std::sqrt(1 - sine2);
    const double s = (cosine - eta * t) / (cosine + eta * t), p = (eta * cosine - t) / (eta * cosine + t);
    return {s * s, p * p};
}

double unpolarised(double cosine, double eta) {
    const auto [s, p] = fresnel(cosine, eta);
    return (s + p) / 2;
}

}  // namespace cardioid::test
