# SPDX-License-Identifier: GPL-3.0-or-later
# palpate_leave_out_python_targets(FOLDER): to be called before find_package() of the ParaView or VTK whose CMake files are there.
# Debian 13 names Python's modules with the interpreter's suffix, ParaView's list of targets names them without, and CMake
# refuses a target whose file is missing. Nothing is linked to these modules. CMake does not look for the file of a target
# that has a folder in the variables set here.
macro (palpate_leave_out_python_targets palpate_folder)
  file(GLOB palpate_lists "${palpate_folder}/*Python*-targets-*.cmake" "${palpate_folder}/vtk/*Python*-targets-*.cmake")
  foreach (palpate_list IN LISTS palpate_lists)
    file(STRINGS "${palpate_list}" palpate_checks REGEX "_cmake_import_check_files_for_")
    foreach (palpate_check IN LISTS palpate_checks)
      string(REGEX REPLACE ".*_cmake_import_check_files_for_([^ ]+) .*" "\\1" palpate_target "${palpate_check}")
      string(REGEX REPLACE ".*{_IMPORT_PREFIX}/([^\"]+)\".*" "/usr/\\1" palpate_file "${palpate_check}")
      if (NOT EXISTS "${palpate_file}")
        set("_cmake_import_check_xcframework_for_${palpate_target}" "${palpate_folder}")
      endif ()
    endforeach ()
  endforeach ()
endmacro ()
