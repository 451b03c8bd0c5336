# SPDX-License-Identifier: GPL-3.0-or-later
# palpate_add_touch_test(NAME name BASELINE file.json UNIT mm
#   SURFACE file [COMMAND program argument...]
#   [SCENE scene] [TOLERANCE jnd] [PATH way.csv] [SETTINGS Radius=2...] [LABELS label...] [TIMEOUT seconds])
# Declares the ctest `name`: does the surface in a file feel as the baseline says? `python3 -m palpate.testing --help`
# explains each argument. The surface is vtp, vtu, stl, ply, obj or off; relative names are below the current binary
# folder with a COMMAND, which writes it in the test `name.surface` first, and below the current source folder without.
# PALPATE_UPDATE_BASELINES=1 ctest -R name     writes the baseline
# In the binary folder a test leaves name.junit.xml and, if it fails, name.differs.vtp for ParaView.
function (palpate_add_touch_test)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "NAME;BASELINE;UNIT;SURFACE;SCENE;TOLERANCE;PATH;TIMEOUT" "COMMAND;SETTINGS;LABELS")
  foreach (needed IN ITEMS NAME BASELINE UNIT SURFACE)
    if (NOT arg_${needed})
      message(FATAL_ERROR "palpate_add_touch_test(${arg_NAME}): ${needed} is missing")
    endif ()
  endforeach ()
  if (arg_UNPARSED_ARGUMENTS OR arg_KEYWORDS_MISSING_VALUES)
    message(FATAL_ERROR "palpate_add_touch_test(${arg_NAME}): unknown or without a value: ${arg_UNPARSED_ARGUMENTS} ${arg_KEYWORDS_MISSING_VALUES}")
  endif ()
  if (NOT arg_TIMEOUT)
    set(arg_TIMEOUT 120)
  endif ()
  # Debian's Python is the one that sees ParaView's VTK.
  find_program(PALPATE_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH REQUIRED DOC "Python that sees ParaView's VTK")

  cmake_path(ABSOLUTE_PATH arg_BASELINE BASE_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}")
  set(folder "${CMAKE_CURRENT_SOURCE_DIR}")
  if (arg_COMMAND)
    set(folder "${CMAKE_CURRENT_BINARY_DIR}")
  endif ()
  cmake_path(ABSOLUTE_PATH arg_SURFACE BASE_DIRECTORY "${folder}")
  set(options --unit "${arg_UNIT}" --junit "${CMAKE_CURRENT_BINARY_DIR}/${arg_NAME}.junit.xml"
    --differences "${CMAKE_CURRENT_BINARY_DIR}/${arg_NAME}.differs.vtp")
  if (arg_PATH)
    cmake_path(ABSOLUTE_PATH arg_PATH BASE_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}")
  endif ()
  foreach (option IN ITEMS SCENE TOLERANCE PATH)
    if (DEFINED arg_${option})
      string(TOLOWER "--${option}" word)
      list(APPEND options "${word}" "${arg_${option}}")
    endif ()
  endforeach ()
  foreach (setting IN LISTS arg_SETTINGS)
    list(APPEND options --set "${setting}")
  endforeach ()

  add_test(NAME "${arg_NAME}" COMMAND "${PALPATE_PYTHON}" -m palpate.testing "${arg_SURFACE}" "${arg_BASELINE}" ${options})
  set_tests_properties("${arg_NAME}" PROPERTIES LABELS "${arg_LABELS}" TIMEOUT "${arg_TIMEOUT}"
    ENVIRONMENT_MODIFICATION "PYTHONPATH=path_list_prepend:${Palpate_PYTHON_DIR}")
  if (arg_COMMAND)
    add_test(NAME "${arg_NAME}.surface" COMMAND ${arg_COMMAND} WORKING_DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}")
    set_tests_properties("${arg_NAME}.surface" PROPERTIES FIXTURES_SETUP "${arg_NAME}" TIMEOUT "${arg_TIMEOUT}")
    set_tests_properties("${arg_NAME}" PROPERTIES FIXTURES_REQUIRED "${arg_NAME}")
  endif ()
endfunction ()
