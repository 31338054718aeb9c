#pragma once
#include <array>
#include <vector>

#include "rt_core/api/math.hpp"

namespace cardioid::test {

/// Faces z = 0, z = 1, x = 0, x = 1, y = 0, y = 1 of the unit cube.
using SixFaces = std::array<double, 6>;

/// The radiosity equation of the unit cube by collocation on a mesh that is finer towards the edges; the form factors
/// from points to patches are exact. Errors fall with the square of the patch size.
class CubeRadiosity {
public:
    /// patches along an edge, at least 2.
    explicit CubeRadiosity(int patches);

    /// Radiosity of each patch where faces have radiosity `emission` of their own, and a point source of power `source`
    /// stands in the centre.
    [[nodiscard]] std::vector<double> solve(const SixFaces& reflectance, const SixFaces& emission, double source) const;
    /// Irradiance at p on a face, of patches of that radiosity and the source.
    [[nodiscard]] double irradiance(const std::vector<double>& radiosity, double source, int face, Vec3d p) const;

private:
    /// Form factors from a point of a face to all patches.
    [[nodiscard]] std::vector<double> factors(int face, Vec3d p) const;
    [[nodiscard]] std::size_t patch_count() const { return 6 * static_cast<std::size_t>(patches_ * patches_); }

    int patches_;
    std::vector<double> edges_;
    std::vector<std::vector<double>> rows_;  ///< of each patch
    std::vector<Vec3d> centres_;
};

/// Irradiance from meshes of 8 and 16 patches, extrapolated; about 1e-4 of the value at points away from edges.
double cube_irradiance(const SixFaces& reflectance, const SixFaces& emission, double source, int face, Vec3d p);

}  // namespace cardioid::test
