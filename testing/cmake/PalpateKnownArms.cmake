# SPDX-License-Identifier: GPL-3.0-or-later
# palpate_build_in_arms(RESULT): the arms of data/arms as a source in the binary folder, whose path RESULT is set to. Their
# numbers so stand in one place.
function (palpate_build_in_arms RESULT)
  cmake_path(GET CMAKE_CURRENT_FUNCTION_LIST_DIR PARENT_PATH root)
  cmake_path(GET root PARENT_PATH root)
  set(palpate_known_arms "")
  foreach (name IN ITEMS falcon woodenhaptics-2015 polhem-v1 aluhaptics-v2 pantograph delta-wrist)
    set(file "${root}/data/arms/${name}.json")
    file(READ "${file}" text)
    string(APPEND palpate_known_arms "  KnownFile{ \"${name}\", R\"json(${text})json\" },\n")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${file}")
  endforeach ()
  configure_file("${root}/haptics/arm/file/KnownArms.cpp.in" "${CMAKE_CURRENT_BINARY_DIR}/KnownArms.cpp" @ONLY)
  set("${RESULT}" "${CMAKE_CURRENT_BINARY_DIR}/KnownArms.cpp" PARENT_SCOPE)
endfunction ()
