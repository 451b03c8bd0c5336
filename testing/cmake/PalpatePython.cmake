# SPDX-License-Identifier: GPL-3.0-or-later
# The Python sources of the package `palpate`, beside the wrapped modules: linked in the build tree, installed with
# them.

set(palpate_package "${CMAKE_INSTALL_LIBDIR}/python/palpate")
file(MAKE_DIRECTORY "${CMAKE_BINARY_DIR}/${palpate_package}")
configure_file("${CMAKE_CURRENT_SOURCE_DIR}/filters/pipeline/python/__init__.py.in"
  "${CMAKE_BINARY_DIR}/${palpate_package}/__init__.py" @ONLY)
install(FILES "${CMAKE_BINARY_DIR}/${palpate_package}/__init__.py" DESTINATION "${palpate_package}")

function (palpate_add_python source)
  cmake_path(GET source FILENAME name)
  file(CREATE_LINK "${CMAKE_CURRENT_SOURCE_DIR}/${source}" "${CMAKE_BINARY_DIR}/${palpate_package}/${name}" SYMBOLIC)
  if (IS_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}/${source}")
    install(DIRECTORY "${source}" DESTINATION "${palpate_package}" FILES_MATCHING PATTERN "*.py"
      PATTERN "__pycache__" EXCLUDE)
  else ()
    install(FILES "${source}" DESTINATION "${palpate_package}")
  endif ()
endfunction ()

palpate_add_python(filters/pipeline/python/testing)
if (PALPATE_VTK STREQUAL "paraview")
  palpate_add_python(filters/views/python/simple.py)
endif ()
