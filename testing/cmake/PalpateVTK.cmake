# SPDX-License-Identifier: GPL-3.0-or-later
# The two modules that need neither ParaView nor Qt: against ParaView's VTK, or against the system's for programs of VTK's own Python.

set(modules "${CMAKE_CURRENT_SOURCE_DIR}/filters/pipeline/vtk.module" "${CMAKE_CURRENT_SOURCE_DIR}/filters/interaction/vtk.module")
if (PALPATE_VTK STREQUAL "system")
  # Only components that the modules name: the whole of VTK needs Qt, MPI and more.
  set(components WrappingPythonCore)
  foreach (module IN LISTS modules)
    file(STRINGS "${module}" names REGEX "^ +VTK::")
    list(APPEND components ${names})
  endforeach ()
  list(TRANSFORM components STRIP)
  list(TRANSFORM components REPLACE "^VTK::" "")
  list(REMOVE_DUPLICATES components)
  find_package(VTK REQUIRED COMPONENTS ${components})
else ()
  find_package(VTK REQUIRED PATHS "${ParaView_DIR}/vtk" NO_DEFAULT_PATH)
endif ()
set(BUILD_SHARED_LIBS ON)

vtk_module_scan(
  MODULE_FILES ${modules}
  PROVIDES_MODULES palpate_modules
  WANT_BY_DEFAULT ON
  ENABLE_TESTS OFF)
vtk_module_build(
  MODULES ${palpate_modules}
  LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  HEADERS_DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/palpate/vtk")

set(palpate_python_targets vtkHapticPipelinePython vtkHapticInteractionPython)
vtk_module_wrap_python(
  MODULES ${palpate_modules}
  TARGET PalpatePython
  PYTHON_PACKAGE "palpate"
  MODULE_DESTINATION "${CMAKE_INSTALL_LIBDIR}/python"
  BUILD_STATIC OFF
  INSTALL_HEADERS OFF)
foreach (wrapper IN LISTS palpate_python_targets)
  palpate_compile_together("${wrapper}")
  target_compile_options("${wrapper}" PRIVATE -Wno-missing-field-initializers) # of types that are newer than VTK's generator
endforeach ()
