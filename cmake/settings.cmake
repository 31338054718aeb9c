# Language, warnings and code generation, as the targets cardioid::settings and cardioid::warnings.
include(GNUInstallDirs)

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Debug, Release, RelWithDebInfo" FORCE)
endif()

if(CARDIOID_CCACHE)
  find_program(CCACHE_PROGRAM ccache)
  if(CCACHE_PROGRAM)
    set(CMAKE_C_COMPILER_LAUNCHER ${CCACHE_PROGRAM})
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE_PROGRAM})
  endif()
endif()

# Where programs look for our module of picture formats, in the build folder and installed.
set(CMAKE_BUILD_RPATH ${PROJECT_BINARY_DIR}/rt_core)
set(CMAKE_INSTALL_RPATH $ORIGIN/../${CMAKE_INSTALL_LIBDIR}/cardioid)

# CGAL's units need a gigabyte each, so only one of them compiles at a time.
set_property(GLOBAL APPEND PROPERTY JOB_POOLS heavy=1)

add_library(cardioid_settings INTERFACE)
add_library(cardioid::settings ALIAS cardioid_settings)
target_compile_features(cardioid_settings INTERFACE cxx_std_20)
target_include_directories(cardioid_settings INTERFACE
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/cardioid>)
# Contraction off: the same picture from gcc and clang, with or without FMA.
target_compile_options(cardioid_settings INTERFACE -ffp-contract=off -fno-math-errno
                       $<$<BOOL:${CARDIOID_NATIVE}>:-march=native>)
target_compile_definitions(cardioid_settings INTERFACE CARDIOID_VERSION="${PROJECT_VERSION}"
                           $<$<OR:$<CONFIG:Debug>,$<BOOL:${CARDIOID_ASSERTIONS}>>:CARDIOID_ASSERTIONS>)

add_library(cardioid_warnings INTERFACE)
add_library(cardioid::warnings ALIAS cardioid_warnings)
target_compile_options(cardioid_warnings INTERFACE -Wall -Wextra -Wconversion -Wshadow -Wno-missing-field-initializers)
