# SPDX-License-Identifier: GPL-3.0-or-later
# Language, flags and output folders of the whole tree.

if (NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif ()
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG")
# A contracted a*b+c rounds once instead of twice: results would depend on the processor, and exact predicates break.
add_compile_options(-Wall -Wextra -ffp-contract=off)
if (CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 13)
  add_compile_options(-Wno-array-bounds) # of GCC's own moved strings; GCC 12, which does not invent them, still looks
endif ()

if (PALPATE_SANITIZE)
  if (NOT PALPATE_VTK STREQUAL "none")
    message(FATAL_ERROR "PALPATE_SANITIZE needs PALPATE_VTK=none: ParaView itself is not instrumented")
  endif ()
  add_compile_options(-fsanitize=${PALPATE_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_compile_definitions(PALPATE_SANITIZED)
  add_link_options(-fsanitize=${PALPATE_SANITIZE})
endif ()

# Results of the compiler are kept from one build to the next where ccache is installed. -fpch-preprocess keeps
# precompiled headers apart from the source in ccache's hash; __TIME__, which ccache fears in them, stands nowhere in
# this tree.
option(PALPATE_CCACHE "Compile through ccache where it is installed" ON)
find_program(PALPATE_CCACHE_PROGRAM ccache)
mark_as_advanced(PALPATE_CCACHE_PROGRAM)
if (PALPATE_CCACHE AND PALPATE_CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER
    "${CMAKE_COMMAND}" -E env "CCACHE_SLOPPINESS=pch_defines,time_macros" "${PALPATE_CCACHE_PROGRAM}")
  add_compile_options("$<$<COMPILE_LANG_AND_ID:CXX,GNU>:-fpch-preprocess>")
endif ()

# Most of the compile time goes into headers that all sources of a target include.
option(PALPATE_TOGETHER "Compile sources of a target eight at once: half the time from scratch, longer after a change" ON)
function (palpate_compile_together target)
  set_target_properties("${target}" PROPERTIES UNITY_BUILD "${PALPATE_TOGETHER}" UNITY_BUILD_BATCH_SIZE 8)
endfunction ()
# The sources of a folder at once, where a target has many folders. Their names for things of their own differ.
function (palpate_compile_rooms_together target)
  get_target_property(sources "${target}" SOURCES)
  get_target_property(folder "${target}" SOURCE_DIR)
  foreach (source IN LISTS sources)
    cmake_path(GET source PARENT_PATH room)
    cmake_path(ABSOLUTE_PATH room BASE_DIRECTORY "${folder}" NORMALIZE)
    cmake_path(RELATIVE_PATH room BASE_DIRECTORY "${PROJECT_SOURCE_DIR}")
    string(MAKE_C_IDENTIFIER "${room}" room)
    set_source_files_properties("${source}" TARGET_DIRECTORY "${target}" PROPERTIES UNITY_GROUP "${room}")
  endforeach ()
  set_target_properties("${target}" PROPERTIES UNITY_BUILD "${PALPATE_TOGETHER}" UNITY_BUILD_MODE GROUP)
endfunction ()

set(CMAKE_INSTALL_LIBDIR lib CACHE STRING "Library folder, the same in the build tree on every machine")
include(GNUInstallDirs)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_BINDIR}")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")
set(PALPATE_PLUGIN_DIR "${CMAKE_INSTALL_LIBDIR}/paraview-${PALPATE_PARAVIEW}/plugins")
# Installed parts find one another wherever the prefix is: from bin/, lib/, the plugin's folder, lib/python/palpate/ and
# lib/python3/dist-packages/palpate/.
set(CMAKE_INSTALL_RPATH "$ORIGIN" "$ORIGIN/../${CMAKE_INSTALL_LIBDIR}" "$ORIGIN/../${PALPATE_PLUGIN_DIR}/Palpate"
  "$ORIGIN/../../.." "$ORIGIN/../.." "$ORIGIN/../../paraview-${PALPATE_PARAVIEW}/plugins/Palpate"
  "$ORIGIN/../../../paraview-${PALPATE_PARAVIEW}/plugins/Palpate")
