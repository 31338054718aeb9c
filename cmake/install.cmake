# Installing: the program, the headers a plug-in or a tool includes, documents, and the package that
# find_package(cardioid) finds. The package works from the build folder too: -Dcardioid_DIR=build/release.
include(CMakePackageConfigHelpers)

set(CARDIOID_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/cardioid)

install(TARGETS cardioid_program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS cardioid_images LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/cardioid)
install(DIRECTORY rt_core/api rt_core/math rt_core/scene
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/cardioid/rt_core
        FILES_MATCHING PATTERN "*.hpp" PATTERN "*.h")
install(FILES README.md CHANGELOG.md LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/docs FILES_MATCHING PATTERN "*.md" PATTERN "*.png")
install(DIRECTORY samples DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES share/cardioid.scad DESTINATION ${CMAKE_INSTALL_DATADIR}/cardioid)

set_target_properties(cardioid_api PROPERTIES EXPORT_NAME api)
set_target_properties(cardioid_settings PROPERTIES EXPORT_NAME settings)
install(TARGETS cardioid_api cardioid_settings EXPORT cardioid-targets)
install(EXPORT cardioid-targets NAMESPACE cardioid:: DESTINATION ${CARDIOID_PACKAGE_DIR})
export(EXPORT cardioid-targets NAMESPACE cardioid:: FILE ${PROJECT_BINARY_DIR}/cardioid-targets.cmake)

configure_package_config_file(cmake/cardioid-config.cmake.in ${PROJECT_BINARY_DIR}/cardioid-config.cmake
  INSTALL_DESTINATION ${CARDIOID_PACKAGE_DIR})
# Before 1.0 every minor version may change a hook; the ABI number in plugin.h has the last word.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/cardioid-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/cardioid-config.cmake ${PROJECT_BINARY_DIR}/cardioid-config-version.cmake
        DESTINATION ${CARDIOID_PACKAGE_DIR})
