# Every package the project is built from; all are in Debian.
find_package(OpenMP REQUIRED COMPONENTS CXX)
find_package(fmt REQUIRED)
find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(OpenImageIO REQUIRED)
# Debian's OpenImageIO names the folder of OpenCV's headers, which it does not bring and nobody needs.
get_target_property(openimageio_folders OpenImageIO::OpenImageIO INTERFACE_INCLUDE_DIRECTORIES)
foreach(folder IN LISTS openimageio_folders)
  if(IS_ABSOLUTE "${folder}" AND NOT EXISTS "${folder}")
    list(REMOVE_ITEM openimageio_folders "${folder}")
  endif()
endforeach()
set_target_properties(OpenImageIO::OpenImageIO PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${openimageio_folders}")
include(${CMAKE_CURRENT_LIST_DIR}/openimageio_libraries.cmake)
find_package(CGAL REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(polyclipping REQUIRED IMPORTED_TARGET polyclipping)
# What text() needs: which font, its outlines, and where its glyphs stand.
pkg_check_modules(text REQUIRED IMPORTED_TARGET fontconfig freetype2 harfbuzz)
find_package(pugixml REQUIRED)
find_package(ZLIB REQUIRED)

# Embree 4 (Debian 13) where it is, else 3.13 (Debian 12); rt_core/trace/embree.hpp levels the two.
find_package(embree 4 QUIET)
if(NOT embree_FOUND)
  find_package(embree 3 REQUIRED)
endif()
message(STATUS "Embree ${embree_VERSION}, OpenImageIO ${OpenImageIO_VERSION}, CGAL ${CGAL_VERSION}")
