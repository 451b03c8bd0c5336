# SPDX-License-Identifier: GPL-3.0-or-later
# The plugin with its three VTK modules and the Python package, against ParaView's own VTK (never another one).

find_package(ParaView REQUIRED)
set(BUILD_SHARED_LIBS ON)

set(palpate_plugin_modules Palpate::vtkHapticPipeline Palpate::vtkHapticInteraction Palpate::vtkHapticViews)

paraview_plugin_scan(
  PLUGIN_FILES "${CMAKE_CURRENT_SOURCE_DIR}/plugin/paraview.plugin"
  PROVIDES_PLUGINS palpate_plugins
  REQUIRES_MODULES palpate_required_modules
  ENABLE_BY_DEFAULT ON)
paraview_plugin_build(
  RUNTIME_DESTINATION "${CMAKE_INSTALL_BINDIR}"
  LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  LIBRARY_SUBDIRECTORY "paraview-${PALPATE_PARAVIEW}/plugins"
  HEADERS_DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/palpate/vtk"
  AUTOLOAD Palpate
  PLUGINS_FILE_NAME "palpate.plugins.xml"
  DISABLE_XML_DOCUMENTATION ON
  PLUGINS ${palpate_plugins})

set(palpate_python_targets vtkHapticPipelinePython vtkHapticInteractionPython vtkHapticViewsPython)
vtk_module_wrap_python(
  MODULES ${palpate_plugin_modules}
  TARGET PalpatePython
  PYTHON_PACKAGE "palpate"
  MODULE_DESTINATION "${CMAKE_INSTALL_LIBDIR}/python"
  BUILD_STATIC OFF
  INSTALL_HEADERS OFF)
foreach (wrapper IN LISTS palpate_python_targets)
  palpate_compile_together("${wrapper}")
  target_compile_options("${wrapper}" PRIVATE -Wno-missing-field-initializers) # of types that are newer than VTK's generator
endforeach ()
