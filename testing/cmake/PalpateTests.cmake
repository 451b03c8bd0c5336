# SPDX-License-Identifier: GPL-3.0-or-later
# One function per kind of test. Every test gets a label (unit, filters, plugin, gui, lab, vm or fuzz) and a timeout.
# Arguments common to all:
#   NAME name          name of the test, and of its target where there is one
#   LABEL label        default: given at each function
#   TIMEOUT seconds    default 120; times PALPATE_TIMEOUT_FACTOR where that is set (./dev test --full)
#   ENVIRONMENT A=b... variables of the test's process
#   SERIAL             nothing else runs beside it (tests that compare costs)
#   COST seconds       about how long it takes: ctest starts the longest first, so that no core idles at the end. Default: 20 of gui
#                      and plugin, 10 of fuzz and filters, 0 of the others
#   GROUP name         its program is built apart (palpate_build_apart), before the first test of that group
#   IN_TURN            ./dev test runs it at one commit in seven (support/turns.py); not for suites that are discovered

find_package(GTest REQUIRED)

set(PALPATE_TEST_OUTPUT "${CMAKE_BINARY_DIR}/Testing/Temporary")
set(PALPATE_PYTHON_PATH "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}/python")
set(PALPATE_PLUGIN_PATH "${CMAKE_BINARY_DIR}/${PALPATE_PLUGIN_DIR}/Palpate")

# Where a test finds the products of this build.
set(PALPATE_TEST_ENVIRONMENT
  "PYTHONPATH=${PALPATE_PYTHON_PATH}:${PROJECT_SOURCE_DIR}/testing/support"
  "PYTHONDONTWRITEBYTECODE=1"
  "PALPATE_SOURCE_DIR=${PROJECT_SOURCE_DIR}"
  "PALPATE_BUILD_DIR=${CMAKE_BINARY_DIR}"
  "PALPATE_PARAVIEW=${PALPATE_PARAVIEW}"
  "PALPATE_PROGRAM=${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/palpate"
  "PALPATE_PLUGIN=${PALPATE_PLUGIN_PATH}/Palpate.so"
  "PV_PLUGIN_PATH=${PALPATE_PLUGIN_PATH}"
  "XDG_CONFIG_HOME=${PALPATE_TEST_OUTPUT}/settings") # never the person's own: settings of a test stay in the build

# Of two ranks on any machine, in a container too, where the tests run as root.
set(PALPATE_MPI_ENVIRONMENT
  "OMPI_ALLOW_RUN_AS_ROOT=1" "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1" "OMPI_MCA_rmaps_base_oversubscribe=1")

# The shares that commits take turns with, with the targets that build them: those of support/turns.py. The last has no tests.
set(PALPATE_TURNS turn-0 turn-1 turn-2 turn-3 turn-4 turn-none)
foreach (turn IN LISTS PALPATE_TURNS)
  add_custom_target("${turn}")
endforeach ()
# Programs that are built apart and that every commit tries.
add_custom_target(palpate_every_turn)
add_custom_target(palpate_apart)

# Sets RESULT to the next share: they are dealt out in the order of the tests, so that neighbours, which cost alike, are far apart.
function (_palpate_next_turn RESULT)
  get_property(dealt GLOBAL PROPERTY PALPATE_TURNS_DEALT)
  math(EXPR next "0${dealt} % 5")
  list(GET PALPATE_TURNS "${next}" turn)
  math(EXPR dealt "${next} + 1")
  set_property(GLOBAL PROPERTY PALPATE_TURNS_DEALT "${dealt}")
  set("${RESULT}" "${turn}" PARENT_SCOPE)
endfunction ()

# Parses ARGN into arg_*; keeps the defaults in one place.
macro (_palpate_parse default_label one_value multi_value)
  cmake_parse_arguments(PARSE_ARGV 0 arg "SERIAL;CGAL;OWN_HEADERS;IN_TURN;AS_RELEASED" "NAME;LABEL;TIMEOUT;COST;GROUP;${one_value}" "ENVIRONMENT;${multi_value}")
  if (arg_UNPARSED_ARGUMENTS OR NOT arg_NAME)
    message(FATAL_ERROR "Test '${arg_NAME}': NAME is missing, or these arguments are unknown: ${arg_UNPARSED_ARGUMENTS}")
  endif ()
  if (NOT arg_LABEL)
    set(arg_LABEL "${default_label}")
  endif ()
  if (NOT arg_TIMEOUT)
    set(arg_TIMEOUT 120)
  endif ()
  if (PALPATE_TIMEOUT_FACTOR)
    math(EXPR arg_TIMEOUT "${arg_TIMEOUT} * ${PALPATE_TIMEOUT_FACTOR}")
  endif ()
  if (NOT arg_COST)
    set(arg_COST 0)
    if (arg_LABEL MATCHES "^(gui|plugin)$")
      set(arg_COST 20)
    elseif (arg_LABEL MATCHES "^(fuzz|filters)$")
      set(arg_COST 10)
    endif ()
  endif ()
  if (NOT arg_SERIAL)
    set(arg_SERIAL OFF)
  endif ()
  set(arg_TURN "")
  if (arg_IN_TURN)
    _palpate_next_turn(arg_TURN)
  endif ()
  list(PREPEND arg_ENVIRONMENT ${PALPATE_TEST_ENVIRONMENT})
endmacro ()

function (_palpate_set_properties test)
  set(labels "${arg_LABEL}" ${arg_TURN})
  set_tests_properties("${test}" PROPERTIES
    LABELS "${labels}" TIMEOUT "${arg_TIMEOUT}" COST "${arg_COST}" RUN_SERIAL "${arg_SERIAL}" ENVIRONMENT "${arg_ENVIRONMENT}")
  if (arg_GROUP)
    _palpate_share_of(share "${arg_GROUP}" "${arg_TURN}")
    set_tests_properties("${test}" PROPERTIES FIXTURES_REQUIRED "${share}")
  endif ()
endfunction ()

# Sets RESULT to the target of those programs of a group that one turn has; TURN may be "".
function (_palpate_share_of RESULT group turn)
  set(share "${group}-every-turn")
  if (turn)
    set(share "${group}-${turn}")
  endif ()
  set("${RESULT}" "${share}" PARENT_SCOPE)
endfunction ()

# palpate_build_apart(GROUP TURN target...): targets that only their own tests run. The default target leaves them out; ctest builds
# those of the group and the turn before the first of their tests (a fixture, which ctest adds to whatever it selects), so that a test
# never runs an old program. To build them by hand: ninja -C build GROUP, or all groups: ninja -C build palpate_apart. TURN: arg_TURN.
function (palpate_build_apart group turn)
  if (NOT TARGET "${group}")
    add_custom_target("${group}")
    add_dependencies(palpate_apart "${group}")
  endif ()
  _palpate_share_of(share "${group}" "${turn}")
  if (NOT TARGET "${share}")
    add_custom_target("${share}")
    add_dependencies("${group}" "${share}")
    if (turn)
      add_dependencies("${turn}" "${share}")
    else ()
      add_dependencies(palpate_every_turn "${share}")
    endif ()
    add_test(NAME "build.${share}" COMMAND "${CMAKE_COMMAND}" --build "${CMAKE_BINARY_DIR}" --target "${share}")
    # The compilers take all cores: nothing else is started beside them.
    set_tests_properties("build.${share}" PROPERTIES FIXTURES_SETUP "${share}" LABELS "${turn}" TIMEOUT 3600 RUN_SERIAL ON)
  endif ()
  set_target_properties(${ARGN} PROPERTIES EXCLUDE_FROM_ALL ON)
  add_dependencies("${share}" ${ARGN})
endfunction ()

# Parsing the headers that every test includes is most of its compile time: one test compiles them, those with the same flags
# take them over. CGAL and Qt bring flags of their own, programs of a GROUP are built by whoever tries them, alone. FLAGS: a name for
# the flags.
set(palpate_test_headers <gmock/gmock.h> <gtest/gtest.h> <Eigen/Core> <Eigen/Geometry> <algorithm> <memory> <string> <vector>)
function (palpate_share_test_headers target flags)
  get_property(first GLOBAL PROPERTY "PALPATE_TEST_HEADERS_${flags}")
  if (first)
    target_precompile_headers("${target}" REUSE_FROM "${first}")
    return ()
  endif ()
  target_precompile_headers("${target}" PRIVATE ${palpate_test_headers})
  set_property(GLOBAL PROPERTY "PALPATE_TEST_HEADERS_${flags}" "${target}")
endfunction ()

# palpate_add_unit_test(NAME contact SOURCES TestA.cpp TestB.cpp [LIBRARIES ...] [CGAL] [OWN_HEADERS] [AS_RELEASED]
#   [VTK_MODULES VTK::IOXML ...])
# A GoogleTest program linked to the core and testing/support; each suite becomes a ctest "name.Suite", or with
# PALPATE_TIMEOUT_FACTOR, each TEST "name.Suite.Test" (DiscoverTests.cmake). Its own sources are
# compiled at -O1, which takes a sixth less time; AS_RELEASED: at -O2, for judges that compute longer than they compile.
# Label: unit. CGAL: the sources use CGAL (oracles). Eight sources are compiled at once, so they name things differently.
# OWN_HEADERS: the caller precompiles others. VTK_MODULES: linked and auto-initialised. With GROUP it is one ctest, "name": its tests can be listed only once it is built.
function (palpate_add_unit_test)
  _palpate_parse(unit "" "SOURCES;LIBRARIES;VTK_MODULES")
  add_executable("${arg_NAME}" ${arg_SOURCES})
  palpate_compile_together("${arg_NAME}")
  target_link_libraries("${arg_NAME}" PRIVATE Palpate::core palpate_testing ${arg_LIBRARIES} ${arg_VTK_MODULES}
    GTest::gmock GTest::gtest_main)
  if (arg_CGAL)
    target_link_libraries("${arg_NAME}" PRIVATE CGAL::CGAL)
  endif ()
  set(flags released)
  if (NOT arg_AS_RELEASED)
    set(flags tests)
    target_compile_options("${arg_NAME}" PRIVATE "$<$<CONFIG:Release>:-O1>")
  endif ()
  if (NOT arg_CGAL AND NOT arg_GROUP AND NOT "${arg_LIBRARIES}" MATCHES "Qt[0-9]::" AND NOT arg_OWN_HEADERS)
    palpate_share_test_headers("${arg_NAME}" "${flags}")
  endif ()
  if (arg_VTK_MODULES)
    vtk_module_autoinit(TARGETS "${arg_NAME}" MODULES ${arg_VTK_MODULES})
  endif ()
  if (arg_GROUP)
    palpate_build_apart("${arg_GROUP}" "${arg_TURN}" "${arg_NAME}")
    add_test(NAME "${arg_NAME}" COMMAND "${arg_NAME}" --gtest_brief=1)
    _palpate_set_properties("${arg_NAME}")
    return ()
  endif ()
  set(each OFF)
  if (PALPATE_TIMEOUT_FACTOR)
    set(each ON)
  else ()
    math(EXPR arg_TIMEOUT "4 * ${arg_TIMEOUT}") # of a suite
  endif ()
  set(script "${CMAKE_CURRENT_BINARY_DIR}/${arg_NAME}-tests.cmake")
  file(WRITE "${script}" "set(test_program [==[${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/${arg_NAME}]==])
set(test_name \"${arg_NAME}\")
set(test_each ${each})
set(test_properties LABELS \"${arg_LABEL}\" TIMEOUT ${arg_TIMEOUT} COST ${arg_COST} RUN_SERIAL ${arg_SERIAL})
set(test_environment [==[${arg_ENVIRONMENT}]==])
include([==[${PROJECT_SOURCE_DIR}/testing/cmake/DiscoverTests.cmake]==])
")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES "${script}")
endfunction ()

# palpate_add_program_test(NAME x TARGET t [ARGUMENTS ...]): an executable target of ours; exit code 0 passes. Label: unit.
function (palpate_add_program_test)
  _palpate_parse(unit "TARGET" "ARGUMENTS")
  if (arg_GROUP)
    palpate_build_apart("${arg_GROUP}" "${arg_TURN}" "${arg_TARGET}")
  endif ()
  add_test(NAME "${arg_NAME}" COMMAND "${arg_TARGET}" ${arg_ARGUMENTS})
  _palpate_set_properties("${arg_NAME}")
endfunction ()

# palpate_add_python_test(NAME x SCRIPT x.py [ARGUMENTS ...])
# Runs under /usr/bin/python3 with `palpate` importable. Label: unit. The folder PALPATE_TEST_OUTPUT may be written to.
function (palpate_add_python_test)
  _palpate_parse(unit "SCRIPT" "ARGUMENTS")
  find_package(Python3 REQUIRED COMPONENTS Interpreter)
  add_test(NAME "${arg_NAME}" COMMAND Python3::Interpreter "${CMAKE_CURRENT_SOURCE_DIR}/${arg_SCRIPT}" ${arg_ARGUMENTS})
  _palpate_set_properties("${arg_NAME}")
endfunction ()

# palpate_add_pvpython_test(NAME x SCRIPT x.py [ARGUMENTS ...]): the same under pvpython. Label: plugin.
function (palpate_add_pvpython_test)
  _palpate_parse(plugin "SCRIPT" "ARGUMENTS")
  add_test(NAME "${arg_NAME}"
    COMMAND ParaView::pvpython --dr "${CMAKE_CURRENT_SOURCE_DIR}/${arg_SCRIPT}" ${arg_ARGUMENTS})
  _palpate_set_properties("${arg_NAME}")
endfunction ()

# palpate_add_ranks_test(NAME x SCRIPT x.py): the same under pvbatch on two MPI ranks. Label: plugin.
function (palpate_add_ranks_test)
  _palpate_parse(plugin "SCRIPT" "")
  find_package(MPI REQUIRED COMPONENTS C)
  list(APPEND arg_ENVIRONMENT ${PALPATE_MPI_ENVIRONMENT})
  add_test(NAME "${arg_NAME}" COMMAND "${MPIEXEC_EXECUTABLE}" ${MPIEXEC_NUMPROC_FLAG} 2
    "$<TARGET_FILE:ParaView::pvbatch>" --dr "${CMAKE_CURRENT_SOURCE_DIR}/${arg_SCRIPT}")
  _palpate_set_properties("${arg_NAME}")
endfunction ()

# A client beside others keeps the focus: each has a display of its own. ParaView's functions take one file as the client.
set(palpate_client "${CMAKE_BINARY_DIR}/testing/paraview")
file(GENERATE OUTPUT "${palpate_client}"
  CONTENT "#!/bin/sh\nexec '${PROJECT_SOURCE_DIR}/testing/ui/on_own_display' '$<TARGET_FILE:ParaView::paraview>' \"$@\"\n"
  FILE_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)

# palpate_add_gui_test(NAME HapticDock SCRIPT HapticDock.xml [DATA folder])
# Plays a ParaView event script with the plugin loaded; becomes the ctest "pv.HapticDock". Label: gui.
# NAME must be the script's name without .xml. DATA: where $PARAVIEW_TEST_ROOT/$PARAVIEW_DATA_ROOT point.
function (palpate_add_gui_test)
  _palpate_parse(gui "SCRIPT;DATA" "")
  if (NOT arg_DATA)
    set(arg_DATA "${CMAKE_CURRENT_SOURCE_DIR}")
  endif ()
  set("${arg_NAME}_USES_DIRECT_DATA" ON)
  paraview_add_client_tests(
    CLIENT "${palpate_client}"
    LOAD_PLUGIN Palpate
    PLUGIN_PATH "$<TARGET_FILE_DIR:Palpate>"
    TEST_SCRIPTS "${arg_SCRIPT}")
  list(APPEND arg_ENVIRONMENT "PARAVIEW_DATA_ROOT=${arg_DATA}")
  _palpate_set_properties("pv.${arg_NAME}")
endfunction ()

# palpate_add_server_gui_test(NAME HapticServer SCRIPT HapticServer.xml): the same with the data on a server of this computer, which
# has the plugin too and runs on two ranks; becomes the ctest "pvcs.HapticServer".
function (palpate_add_server_gui_test)
  _palpate_parse(gui "SCRIPT" "")
  set("${arg_NAME}_USES_DIRECT_DATA" ON)
  paraview_add_client_server_tests(
    CLIENT "${palpate_client}"
    LOAD_PLUGIN Palpate
    PLUGIN_PATH "$<TARGET_FILE_DIR:Palpate>"
    TEST_SCRIPTS "${arg_SCRIPT}")
  list(APPEND arg_ENVIRONMENT "PARAVIEW_DATA_ROOT=${CMAKE_CURRENT_SOURCE_DIR}" ${PALPATE_MPI_ENVIRONMENT})
  _palpate_set_properties("pvcs.${arg_NAME}")
endfunction ()

# A ctest of the fuzz target that its caller has added.
function (_palpate_add_fuzz_test test)
  set(found "${CMAKE_CURRENT_BINARY_DIR}/${test}-found")
  file(MAKE_DIRECTORY "${found}")
  add_test(NAME "fuzz.${test}"
    COMMAND "${program}" ${extent} -rss_limit_mb=2048 -timeout=20 -print_final_stats=1
      "-artifact_prefix=${found}/" "${found}" "${CMAKE_CURRENT_SOURCE_DIR}/${arg_CORPUS}")
  _palpate_set_properties("fuzz.${test}")
endfunction ()

# Sets for its caller: sources, with their paths; together, the one file that includes them, as headers take longest; and
# palpate_fuzz_command, the compiler with the flags of every fuzz target.
macro (_palpate_fuzz_together name)
  set(sources ${arg_SOURCES})
  list(TRANSFORM sources PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/" REGEX "^[^/]")
  set(together "${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp")
  list(TRANSFORM sources REPLACE "(.+)" "#include \"\\1\"\n" OUTPUT_VARIABLE includes)
  list(JOIN includes "" includes)
  file(GENERATE OUTPUT "${together}" CONTENT "${includes}")
  get_target_property(eigen Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
  set(palpate_fuzz_command "${PALPATE_CLANG}" -std=c++20 -O1 -gline-tables-only -ffp-contract=off -fno-sanitize-recover=all
    "-I${PROJECT_SOURCE_DIR}" -isystem "${eigen}" -MD -MF "${together}.d")
endmacro ()

# palpate_add_fuzz_part(NAME fuzzed-arms SOURCES ...): sources that several fuzz targets share as PARTS fuzzed-arms, compiled once.
function (palpate_add_fuzz_part)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "NAME" "SOURCES")
  find_program(PALPATE_CLANG clang++)
  if (NOT PALPATE_CLANG)
    return ()
  endif ()
  _palpate_fuzz_together("${arg_NAME}")
  set(object "${CMAKE_CURRENT_BINARY_DIR}/${arg_NAME}.o")
  add_custom_command(OUTPUT "${object}"
    COMMAND ${palpate_fuzz_command} -fsanitize=fuzzer-no-link,address,undefined -MT "${object}" -c "${together}" -o "${object}"
    DEPENDS "${together}" ${sources} DEPFILE "${together}.d"
    COMMENT "Part of fuzz targets ${arg_NAME}" VERBATIM)
  add_custom_target("${arg_NAME}" DEPENDS "${object}") # those that need one output build it through one target
endfunction ()

# palpate_add_fuzz_target(NAME fuzz-clean SOURCES FuzzClean.cpp ../../haptics/geometry/mesh/TriangleMesh.cpp CORPUS folder
#   [PARTS parts...] [OPTIONS flags...] [LIBRARIES flags...] [FULL_RUNS count] [VARIANTS VARIABLE=value...])
# A libFuzzer program built by clang++ with its own instrumented copies of SOURCES (the rest of the build may be GCC),
# compiled at once as their headers take longest, and a ctest that runs it for 5 s, in ./dev test --full for 120 s or
# FULL_RUNS inputs, from the seeds in CORPUS, which it does not change. With VARIANTS, one such ctest for each, with that
# in its environment; in the short form they share 8 s. Label: fuzz.
function (palpate_add_fuzz_target)
  _palpate_parse(fuzz "CORPUS;FULL_RUNS" "SOURCES;PARTS;OPTIONS;LIBRARIES;VARIANTS")
  set(arg_GROUP palpate_fuzzers)
  _palpate_next_turn(arg_TURN)
  find_program(PALPATE_CLANG clang++)
  if (NOT PALPATE_CLANG)
    message(STATUS "Fuzz target ${arg_NAME}: left out, clang++ is not installed")
    return ()
  endif ()
  list(LENGTH arg_VARIANTS variants)
  set(extent -max_total_time=5)
  if (variants GREATER 1)
    math(EXPR share "8 / ${variants}")
    set(extent "-max_total_time=${share}")
  endif ()
  if (PALPATE_TIMEOUT_FACTOR AND arg_FULL_RUNS)
    set(extent "-runs=${arg_FULL_RUNS}")
  elseif (PALPATE_TIMEOUT_FACTOR)
    set(extent -max_total_time=120)
  endif ()
  set(program "${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/${arg_NAME}")
  _palpate_fuzz_together("${arg_NAME}")
  set(parts ${arg_PARTS})
  list(TRANSFORM parts REPLACE "(.+)" "${CMAKE_CURRENT_BINARY_DIR}/\\1.o")
  add_custom_command(OUTPUT "${program}"
    COMMAND ${palpate_fuzz_command} -fsanitize=fuzzer,address,undefined ${arg_OPTIONS}
      -MT "${program}" "${together}" ${parts} ${arg_LIBRARIES} -pthread -o "${program}"
    DEPENDS "${together}" ${sources} ${parts} DEPFILE "${together}.d"
    COMMENT "Fuzz target ${arg_NAME}" VERBATIM COMMAND_EXPAND_LISTS)
  add_custom_target("${arg_NAME}" DEPENDS "${program}")
  foreach (part IN LISTS arg_PARTS)
    add_dependencies("${arg_NAME}" "${part}")
  endforeach ()
  palpate_build_apart(palpate_fuzzers "${arg_TURN}" "${arg_NAME}")
  if (NOT arg_VARIANTS)
    _palpate_add_fuzz_test("${arg_NAME}")
  endif ()
  foreach (arg_ENVIRONMENT IN LISTS arg_VARIANTS)
    string(REGEX REPLACE "^.*=" "" value "${arg_ENVIRONMENT}")
    _palpate_add_fuzz_test("${arg_NAME}.${value}")
  endforeach ()
endfunction ()
