#pragma once
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <cstdint>
#include <stdexcept>

#include "csg/exact/boolean/interruption.hpp"

namespace cardioid::csg {

using ExactKernel = CGAL::Exact_predicates_exact_constructions_kernel;
using ExactMesh = CGAL::Surface_mesh<ExactKernel::Point_3>;

/// Steps from one halfedge to another that a thread may still take on a CountedMesh: CGAL 5.5's corefinement goes in
/// circles for ever where it joins patches to a surface that is no manifold (a cylinder minus a lower one of the same
/// radius). Counting them ends that at the same place on every machine.
inline thread_local std::int64_t steps_left = 0;

inline void count_step() {
    constexpr std::int64_t steps_between_looks = 1 << 14;
    if (--steps_left < 0) throw std::runtime_error("corefinement does not end");
    if (steps_left % steps_between_looks == 0) Interruption::check();
}

/// A surface whose walks are counted; CGAL's algorithms find the functions below by its type.
class CountedMesh : public ExactMesh {};

inline ExactMesh::Halfedge_index next(ExactMesh::Halfedge_index h, const CountedMesh& mesh) {
    count_step();
    return mesh.next(h);
}

inline ExactMesh::Halfedge_index prev(ExactMesh::Halfedge_index h, const CountedMesh& mesh) {
    count_step();
    return mesh.prev(h);
}

}  // namespace cardioid::csg

#define CGAL_GRAPH_TRAITS_INHERITANCE_CLASS_NAME cardioid::csg::CountedMesh
#define CGAL_GRAPH_TRAITS_INHERITANCE_BASE_CLASS_NAME cardioid::csg::ExactMesh
#include <CGAL/boost/graph/graph_traits_inheritance_macros.h>
