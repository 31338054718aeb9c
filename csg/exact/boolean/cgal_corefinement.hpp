#pragma once
// CGAL's corefinement without one of its checks: that each triangulation of a cut face is one, whose time grows
// with the square of the pieces of a face. All other checks stay.
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Projection_traits_3.h>
#include <CGAL/assertions.h>
#include <string_view>

namespace cardioid::csg {

constexpr bool is_slow_check(std::string_view expression) { return expression == "cdt.is_valid()"; }

}  // namespace cardioid::csg

#pragma push_macro("CGAL_assertion")
#undef CGAL_assertion
#define CGAL_assertion(EX)                                                          \
    (cardioid::csg::is_slow_check(#EX) || CGAL::possibly(EX) ? static_cast<void>(0) \
                                                             : ::CGAL::assertion_fail(#EX, __FILE__, __LINE__))
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#pragma pop_macro("CGAL_assertion")
