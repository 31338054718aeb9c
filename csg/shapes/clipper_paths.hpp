#pragma once
#include <polyclipping/clipper.hpp>
#include <span>

#include "rt_core/scene/profile.hpp"

namespace cardioid::csg {

/// The largest power of two that is at most `grid`, doubled until the figures fit into Clipper's range.
double usable_grid(std::span<const Profile> parts, double grid);

/// Runs the boolean; throws Error(bad_input) where Clipper fails. Clipper fails without edges, too: not to be called
/// then.
void execute(ClipperLib::Clipper& clipper, ClipperLib::ClipType type, ClipperLib::Paths& out,
             ClipperLib::PolyFillType fill);

/// The figure on the grid, regularised by the even-odd rule: outer contours counter-clockwise, holes clockwise.
ClipperLib::Paths sanitised(const Profile& profile, double grid);

/// The boolean of what the non-zero rule makes of two sets of contours; they touch themselves in corners only.
ClipperLib::Paths combine(ClipperLib::ClipType type, const ClipperLib::Paths& subject, const ClipperLib::Paths& clip);

/// Paths of at least three corners as a figure.
Profile to_profile(const ClipperLib::Paths& paths, double grid);

}  // namespace cardioid::csg
