# SPDX-License-Identifier: GPL-3.0-or-later
# The plugin with its three VTK modules and the Python package, against ParaView's own VTK (never another one).

find_package(ParaView 5.11 REQUIRED)
set(BUILD_SHARED_LIBS ON)

# A module takes part as soon as its CMakeLists.txt lists a class; ParaView cannot build an empty one.
set(palpate_plugin_modules)
foreach (module IN ITEMS Pipeline Interaction Views)
  string(TOLOWER "${module}" folder)
  file(STRINGS "${CMAKE_CURRENT_SOURCE_DIR}/filters/${folder}/CMakeLists.txt" classes REGEX "^ +vtkHaptic|^ +vtkTouch")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/filters/${folder}/CMakeLists.txt")
  if (NOT classes)
    break () # each module needs the one before it
  endif ()
  list(APPEND palpate_plugin_modules "Palpate::vtkHaptic${module}")
endforeach ()

paraview_plugin_scan(
  PLUGIN_FILES "${CMAKE_CURRENT_SOURCE_DIR}/plugin/paraview.plugin"
  PROVIDES_PLUGINS palpate_plugins
  REQUIRES_MODULES palpate_required_modules
  ENABLE_BY_DEFAULT ON)
paraview_plugin_build(
  RUNTIME_DESTINATION "${CMAKE_INSTALL_BINDIR}"
  LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  LIBRARY_SUBDIRECTORY "paraview-5.11/plugins"
  AUTOLOAD Palpate
  PLUGINS_FILE_NAME "palpate.plugins.xml"
  DISABLE_XML_DOCUMENTATION ON
  PLUGINS ${palpate_plugins})

vtk_module_wrap_python(
  MODULES ${palpate_plugin_modules}
  TARGET PalpatePython
  PYTHON_PACKAGE "palpate"
  MODULE_DESTINATION "${CMAKE_INSTALL_LIBDIR}/python"
  BUILD_STATIC OFF
  INSTALL_HEADERS OFF)
