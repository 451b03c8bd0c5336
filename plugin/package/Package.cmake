# SPDX-License-Identifier: GPL-3.0-or-later
# `cpack` in the build folder: one Debian package for Debian's own ParaView.

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME palpate)
set(CPACK_PACKAGE_VERSION "${PROJECT_VERSION}")
set(PALPATE_PACKAGE_CONTACT "Palpate maintainers <maintainers@palpate.example>" CACHE STRING "Who answers for a package")
set(CPACK_PACKAGE_CONTACT "${PALPATE_PACKAGE_CONTACT}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "touch what ParaView shows")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "Palpate takes the surfaces and fields in a view of ParaView, runs an exact
contact model against them a thousand times a second and sends the force to
a haptic device. This package has the plugin, which ParaView loads by itself,
the Python package palpate with what regression tests need, the program
palpate, the library with its headers, and rules that let those who sit at
the computer use force-feedback devices. Not for clinical use.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
# Debian's names of packages that shlibdeps does not see: the client, its Python, and one minor version of both.
string(REGEX REPLACE "\\..*" "" major "${PALPATE_PARAVIEW}")
string(REGEX REPLACE ".*\\." "" minor "${PALPATE_PARAVIEW}")
math(EXPR minor "${minor} + 1")
set(CPACK_DEBIAN_PACKAGE_DEPENDS
  "paraview (>= ${PALPATE_PARAVIEW}), paraview (<< ${major}.${minor}~), python3-paraview, python3-numpy, python3:any")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "paraview-dev, cmake")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}" "${CMAKE_BINARY_DIR}/${PALPATE_PLUGIN_DIR}/Palpate")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
# Within a minor version the library only gains: a package that links it asks for that version.
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY ">=")
foreach (script IN ITEMS preinst postinst prerm postrm triggers)
  list(APPEND CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA "${CMAKE_CURRENT_LIST_DIR}/${script}")
endforeach ()

set(CPACK_PALPATE_PARAVIEW "${PALPATE_PARAVIEW}")
set(CPACK_PALPATE_PACKAGE_DIR "${CMAKE_CURRENT_LIST_DIR}")
set(CPACK_PRE_BUILD_SCRIPTS "${CMAKE_CURRENT_LIST_DIR}/stage.cmake")
include(CPack)
