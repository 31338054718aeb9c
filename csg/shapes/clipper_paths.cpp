#include "csg/shapes/clipper_paths.hpp"

#include <algorithm>
#include <cmath>

#include "rt_core/api/error.hpp"

namespace cardioid::csg {

namespace {

/// Grid steps a coordinate may have: Clipper computes slopes in double, so further bits would be lost there.
constexpr double most_steps = 0x1p50;

bool is_finite(const std::vector<Vec2d>& contour) {
    return std::ranges::all_of(contour, [](Vec2d p) { return std::isfinite(p.x) && std::isfinite(p.y); });
}

}  // namespace

double usable_grid(std::span<const Profile> parts, double grid) {
    double largest = 0;
    for (const Profile& part : parts)
        for (const auto& contour : part.contours)
            if (is_finite(contour))
                for (const Vec2d p : contour) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
    int exponent = 0, least = 0;
    static_cast<void>(std::frexp(grid > 0 ? grid : 0x1p-16, &exponent));
    static_cast<void>(std::frexp(largest / most_steps, &least));
    return std::ldexp(1.0, largest > 0 ? std::max(exponent - 1, least) : exponent - 1);
}

void execute(ClipperLib::Clipper& clipper, ClipperLib::ClipType type, ClipperLib::Paths& out,
             ClipperLib::PolyFillType fill) {
    try {
        if (clipper.Execute(type, out, fill, fill)) return;
    } catch (const ClipperLib::clipperException&) {  // no more is known than that it failed
    }
    throw Error(ErrorCode::bad_input, "a boolean of plane figures failed: their contours are too tangled for Clipper");
}

ClipperLib::Paths sanitised(const Profile& profile, double grid) {
    ClipperLib::Clipper clipper;
    bool has_edges = false;
    for (const auto& contour : profile.contours) {
        if (!is_finite(contour)) continue;
        ClipperLib::Path path;
        path.reserve(contour.size());
        for (const Vec2d p : contour)
            path.emplace_back(static_cast<ClipperLib::cInt>(p.x / grid), static_cast<ClipperLib::cInt>(p.y / grid));
        has_edges |= clipper.AddPath(path, ClipperLib::ptSubject, true);
    }
    ClipperLib::Paths out;
    if (has_edges) execute(clipper, ClipperLib::ctUnion, out, ClipperLib::pftEvenOdd);
    return out;
}

ClipperLib::Paths combine(ClipperLib::ClipType type, const ClipperLib::Paths& subject, const ClipperLib::Paths& clip) {
    ClipperLib::Clipper clipper;
    clipper.StrictlySimple(true);  // contours may touch themselves in corners only, as extrusions want
    bool has_edges = clipper.AddPaths(subject, ClipperLib::ptSubject, true);
    has_edges |= clipper.AddPaths(clip, ClipperLib::ptClip, true);
    ClipperLib::Paths out;
    if (has_edges) execute(clipper, type, out, ClipperLib::pftNonZero);
    return out;
}

Profile to_profile(const ClipperLib::Paths& paths, double grid) {
    Profile out;
    out.contours.reserve(paths.size());
    for (const ClipperLib::Path& path : paths) {
        std::vector<Vec2d> contour;
        contour.reserve(path.size());
        for (const ClipperLib::IntPoint p : path)
            contour.push_back({static_cast<double>(p.X) * grid, static_cast<double>(p.Y) * grid});
        if (contour.size() >= 3) out.contours.push_back(std::move(contour));
    }
    return out;
}

}  // namespace cardioid::csg
