#pragma once
#include <span>

#include "photon/options/choices.hpp"

namespace cardioid::photon {

/// A choice and how it is written.
template <class Choice>
struct Named {
    const char* name;
    Choice choice;
};

inline constexpr Named<Mode> mode_names[] = {{"physical", Mode::physical}, {"report", Mode::report}};
inline constexpr Named<Directions> directions_names[] = {{"closed", Directions::closed}, {"ball", Directions::ball}};
inline constexpr Named<Shares> shares_names[] = {{"power", Shares::power}, {"even", Shares::even}};
inline constexpr Named<Roulette> roulette_names[] = {{"flux", Roulette::flux}, {"mean", Roulette::mean}};
inline constexpr Named<Store> store_names[] = {{"all", Store::all}, {"absorbed", Store::absorbed}};
inline constexpr Named<Kernel> kernel_names[] = {{"box", Kernel::box},
                                                 {"cone", Kernel::cone},
                                                 {"gauss", Kernel::gauss},
                                                 {"epanechnikov", Kernel::epanechnikov},
                                                 {"biweight", Kernel::biweight}};
inline constexpr Named<EdgeRule> edge_names[] = {
    {"none", EdgeRule::none}, {"report", EdgeRule::report}, {"hull", EdgeRule::hull}, {"probe", EdgeRule::probe}};
inline constexpr Named<Indirect> indirect_names[] = {{"cache", Indirect::cache},
                                                     {"precomputed", Indirect::precomputed},
                                                     {"gather", Indirect::gather},
                                                     {"map", Indirect::map},
                                                     {"none", Indirect::none}};
inline constexpr Named<Strata> strata_names[] = {
    {"cosine", Strata::cosine}, {"solid_angle", Strata::solid_angle}, {"angle", Strata::angle}};

constexpr std::span<const Named<Mode>> names_of(Mode) { return mode_names; }
constexpr std::span<const Named<Directions>> names_of(Directions) { return directions_names; }
constexpr std::span<const Named<Shares>> names_of(Shares) { return shares_names; }
constexpr std::span<const Named<Roulette>> names_of(Roulette) { return roulette_names; }
constexpr std::span<const Named<Store>> names_of(Store) { return store_names; }
constexpr std::span<const Named<Kernel>> names_of(Kernel) { return kernel_names; }
constexpr std::span<const Named<EdgeRule>> names_of(EdgeRule) { return edge_names; }
constexpr std::span<const Named<Indirect>> names_of(Indirect) { return indirect_names; }
constexpr std::span<const Named<Strata>> names_of(Strata) { return strata_names; }

/// As it is written in a scene file.
template <class Choice>
constexpr const char* name_of(Choice choice) {
    for (const auto& [name, named] : names_of(choice))
        if (named == choice) return name;
    return "";
}

}  // namespace cardioid::photon
