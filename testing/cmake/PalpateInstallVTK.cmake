# SPDX-License-Identifier: GPL-3.0-or-later
# For another program that uses the modules without ParaView: find_package(Palpate COMPONENTS VTK).

set(palpate_vtk_modules vtkHapticPipeline vtkHapticInteraction)
set(palpate_vtk_folder "${CMAKE_INSTALL_LIBDIR}")
if (PALPATE_VTK STREQUAL "paraview")
  set(palpate_vtk_folder "${PALPATE_PLUGIN_DIR}/Palpate")
endif ()
install(TARGETS ${palpate_vtk_modules} EXPORT PalpateVTKTargets LIBRARY DESTINATION "${palpate_vtk_folder}")
install(EXPORT PalpateVTKTargets NAMESPACE Palpate:: DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/Palpate")

# The parts of VTK that the modules name.
set(palpate_vtk_components)
foreach (module IN LISTS palpate_vtk_modules)
  get_target_property(libraries "${module}" LINK_LIBRARIES)
  list(FILTER libraries INCLUDE REGEX "^VTK::")
  list(APPEND palpate_vtk_components ${libraries})
endforeach ()
list(TRANSFORM palpate_vtk_components REPLACE "^VTK::" "")
list(REMOVE_DUPLICATES palpate_vtk_components)
list(JOIN palpate_vtk_components " " palpate_vtk_components)

# Where ParaView's VTK is on a machine like this, and the name by which its libraries are known from another VTK's.
string(REGEX REPLACE "^/usr/lib/[^/]+/" "/usr/lib/*/" palpate_vtk_pattern "${VTK_DIR}")
get_target_property(palpate_vtk_library VTK::CommonCore LOCATION)
get_filename_component(palpate_vtk_library "${palpate_vtk_library}" NAME)
string(REGEX REPLACE "\\.so.*" "" palpate_vtk_library "${palpate_vtk_library}")
configure_file("${CMAKE_CURRENT_LIST_DIR}/PalpateVTKModules.cmake.in" "${CMAKE_CURRENT_BINARY_DIR}/PalpateVTKModules.cmake" @ONLY)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/PalpateVTKModules.cmake" "${CMAKE_CURRENT_LIST_DIR}/PalpatePythonTargets.cmake"
  DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/Palpate")
