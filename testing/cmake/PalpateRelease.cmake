# SPDX-License-Identifier: GPL-3.0-or-later
# The release of ParaView that is built against. All that differs between releases and is not C++ stands here.
#   PALPATE_PARAVIEW      its series, which names the folders of plugins: 5.11, 5.13
#   PALPATE_PARAVIEW_QT   the major version of its Qt

set(PALPATE_PARAVIEW "none")
set(PALPATE_PARAVIEW_QT 5)
if (PALPATE_VTK MATCHES "^(none|system)$")
  return()
endif ()

if (NOT ParaView_DIR)
  file(GLOB found "/usr/lib/*/cmake/paraview-*")
  list(SORT found COMPARE NATURAL ORDER DESCENDING)
  list(LENGTH found count)
  if (count GREATER 0)
    list(GET found 0 newest)
    set(ParaView_DIR "${newest}" CACHE PATH "Folder of paraview-config.cmake")
  endif ()
  if (count GREATER 1)
    message(STATUS "Several releases of ParaView are installed: ${found}. The newest is taken; -DParaView_DIR=FOLDER takes another")
  endif ()
endif ()
if (NOT EXISTS "${ParaView_DIR}/paraview-config.cmake")
  message(FATAL_ERROR "ParaView's development files were not found: install paraview-dev, or set ParaView_DIR to the folder of "
    "paraview-config.cmake")
endif ()

file(STRINGS "${ParaView_DIR}/paraview-config.cmake" said REGEX "_VERSION_(MAJOR|MINOR)\" \"|QT_MAJOR_VERSION \"")
string(REGEX REPLACE ".*_VERSION_MAJOR\" \"([0-9]+)\".*_VERSION_MINOR\" \"([0-9]+)\".*" "\\1.\\2" PALPATE_PARAVIEW "${said}")
if (said MATCHES "QT_MAJOR_VERSION \"([0-9]+)\"")
  set(PALPATE_PARAVIEW_QT "${CMAKE_MATCH_1}")
endif ()
set(tested 5.11 5.13 6.1)
if (NOT PALPATE_PARAVIEW IN_LIST tested)
  message(WARNING "Palpate is tested with ParaView ${tested} alone, and this is ${PALPATE_PARAVIEW}")
endif ()

include("${CMAKE_CURRENT_LIST_DIR}/PalpatePythonTargets.cmake")
palpate_leave_out_python_targets("${ParaView_DIR}")
