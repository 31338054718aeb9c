#pragma once
#include <array>

#include "csg/exact/boolean/counted_mesh.hpp"
#include "csg/exact/boolean/exact_solid.hpp"

namespace cardioid::csg {

using ExactPoint = ExactKernel::Point_3;

/// A Nef polyhedron, which only the unit that knows them looks into.
struct NefHolder {
    virtual ~NefHolder() = default;
};

/// What an ExactSolid holds: triangles over points, and what is known of them.
struct ExactData {
    std::vector<ExactPoint> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    Box3d box;
    /// Each edge has two triangles, no point is there twice, nothing runs through itself: corefinement may begin.
    bool sound = false;
    bool plain = false;                      ///< its corners are doubles
    std::shared_ptr<const NefHolder> nef{};  ///< the same solid, where it came from Nef polyhedra

    ExactData() = default;
    ExactData(const ExactData&) = delete;
    ExactData& operator=(const ExactData&) = delete;
    ~ExactData() = default;

    /// Works out all numbers, which forgets how they came about, and the box; brings points and triangles into one
    /// order, for CGAL's depends on addresses. False where a point is there twice.
    bool settle();

private:
    void put_in_order(const std::vector<std::uint32_t>& order);
};

}  // namespace cardioid::csg
