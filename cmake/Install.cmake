# What `cmake --install` puts where: programs into bin, the layers marked INSTALLED into lib and include/ritz, and a
# package file by which another project says find_package(ritz).
include(CMakePackageConfigHelpers)
set(package "${CMAKE_INSTALL_LIBDIR}/cmake/ritz")

# ritz::runtime and ritz::world stand on Eigen alone; ritz::format adds HDF5, which a project that only steps models need not have.
install(TARGETS ritz_base ritz_fem ritz_model ritz_runtime ritz_scene ritz_world EXPORT ritz-runtime
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(TARGETS ritz_files ritz_format EXPORT ritz-format
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT ritz-runtime NAMESPACE ritz:: DESTINATION ${package})
install(EXPORT ritz-format NAMESPACE ritz:: DESTINATION ${package})
install(DIRECTORY "${PROJECT_SOURCE_DIR}/include/ritz" DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.hpp")

configure_package_config_file("${CMAKE_CURRENT_LIST_DIR}/ritzConfig.cmake.in" "${PROJECT_BINARY_DIR}/ritzConfig.cmake"
  INSTALL_DESTINATION ${package})
write_basic_package_version_file("${PROJECT_BINARY_DIR}/ritzConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/ritzConfig.cmake" "${PROJECT_BINARY_DIR}/ritzConfigVersion.cmake"
  DESTINATION ${package})
