# SPDX-License-Identifier: GPL-3.0-or-later
# Between install and packing: files that a Debian package has elsewhere than a prefix of one's own, or has besides.
cmake_minimum_required(VERSION 3.25)
set(root "${CPACK_TEMPORARY_DIRECTORY}/usr")
set(doc "${root}/share/doc/palpate")

function (run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction ()

function (replace file old new)
  file(READ "${file}" text)
  string(REPLACE "${old}" "${new}" text "${text}")
  file(WRITE "${file}" "${text}")
endfunction ()

# Where Debian's python3 and pvpython look.
file(MAKE_DIRECTORY "${root}/lib/python3/dist-packages")
file(RENAME "${root}/lib/python/palpate" "${root}/lib/python3/dist-packages/palpate")
file(REMOVE_RECURSE "${root}/lib/python")
replace("${root}/lib/cmake/Palpate/PalpateConfig.cmake" "/lib/python\"" "/lib/python3/dist-packages\"")

# Parts of ParaView's build that are not used afterwards.
file(GLOB client_server "${root}/lib/libvtkHaptic*CS.a")
file(REMOVE ${client_server})
file(REMOVE_RECURSE "${root}/lib/paraview-${CPACK_PALPATE_PARAVIEW}/plugins/Palpate/vtk")

# ParaView, pvpython, pvbatch and pvserver read this list of plugins beside their own program up to 5.12, where there is no list of
# Debian's, and the other one after that.
configure_file("${CPACK_PALPATE_PACKAGE_DIR}/paraview.conf" "${root}/bin/paraview.conf" @ONLY)
configure_file("${CPACK_PALPATE_PACKAGE_DIR}/plugins.xml" "${root}/share/paraview/plugins" @ONLY)

file(MAKE_DIRECTORY "${doc}" "${root}/share/man/man1" "${root}/share/lintian/overrides")
configure_file("${CPACK_PALPATE_PACKAGE_DIR}/copyright" "${doc}/copyright" COPYONLY)
configure_file("${CPACK_PALPATE_PACKAGE_DIR}/lintian-overrides" "${root}/share/lintian/overrides/palpate" COPYONLY)
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(WRITE "${doc}/changelog" "palpate (${CPACK_PACKAGE_VERSION}) unstable; urgency=medium

  * CHANGELOG.md of the sources says what is new.

 -- ${CPACK_PACKAGE_CONTACT}  ${date}
")
run(gzip -9n "${doc}/changelog")

# The pages are the program's own help.
foreach (command IN ITEMS "" devices arm check touch replay labyrinth turn)
  string(STRIP "palpate ${command}" words)
  string(REPLACE " " "-" name "${words}")
  set(page "${root}/share/man/man1/${name}.1")
  execute_process(COMMAND "${root}/bin/palpate" ${command} --help OUTPUT_VARIABLE said COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCH "^[^\n]+" summary "${said}")
  run(help2man --no-info "--name=${summary}" "--version-string=${CPACK_PACKAGE_VERSION}" "--output=${page}" "${root}/bin/${words}")
  replace("${page}" "\n${words} \\- " "\n${name} \\- ") # man finds a page by its one word
  run(gzip -9n "${page}")
endforeach ()
