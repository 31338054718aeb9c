# Every package the project is built from; all are in Debian.
find_package(OpenMP REQUIRED COMPONENTS CXX)
find_package(fmt REQUIRED)
find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(OpenImageIO REQUIRED)
find_package(CGAL REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(polyclipping REQUIRED IMPORTED_TARGET polyclipping)

# Embree 4 (Debian 13) where it is, else 3.13 (Debian 12); rt_core/trace/embree.hpp levels the two.
find_package(embree 4 QUIET)
if(NOT embree_FOUND)
  find_package(embree 3 REQUIRED)
endif()
message(STATUS "Embree ${embree_VERSION}, OpenImageIO ${OpenImageIO_VERSION}, CGAL ${CGAL_VERSION}")
