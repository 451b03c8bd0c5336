# SPDX-License-Identifier: GPL-3.0-or-later
# For another program that uses the core: library, headers and find_package(Palpate). `--component core` installs it
# alone.

include(CMakePackageConfigHelpers)
set(package "${CMAKE_INSTALL_LIBDIR}/cmake/Palpate")

set_target_properties(palpate_core PROPERTIES EXPORT_NAME core)
target_compile_features(palpate_core PUBLIC cxx_std_20)
# Headers name one another from the root of the sources.
target_include_directories(palpate_core INTERFACE "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/palpate>")
# Eigen's types lie in the library's structs. A program compiled for wider vectors would align them otherwise.
target_compile_definitions(palpate_core INTERFACE "$<INSTALL_INTERFACE:EIGEN_MAX_ALIGN_BYTES=16>")

install(TARGETS palpate_core EXPORT PalpateTargets COMPONENT core LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}")
install(DIRECTORY haptics devices DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/palpate" COMPONENT core
  FILES_MATCHING PATTERN "*.h")
install(EXPORT PalpateTargets NAMESPACE Palpate:: DESTINATION "${package}" COMPONENT core)
set(palpate_python_dir "${CMAKE_INSTALL_LIBDIR}/python")
configure_package_config_file("${CMAKE_CURRENT_LIST_DIR}/PalpateConfig.cmake.in" "${CMAKE_CURRENT_BINARY_DIR}/PalpateConfig.cmake"
  INSTALL_DESTINATION "${package}" PATH_VARS palpate_python_dir)
# Before 1.0 any minor version may change the interface of a program.
write_basic_package_version_file("${CMAKE_CURRENT_BINARY_DIR}/PalpateConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/PalpateConfig.cmake" "${CMAKE_CURRENT_BINARY_DIR}/PalpateConfigVersion.cmake"
    "${CMAKE_CURRENT_LIST_DIR}/PalpateTouchTest.cmake"
  DESTINATION "${package}" COMPONENT core)
