# SPDX-License-Identifier: GPL-3.0-or-later
# Read by ctest, once its caller has set these: each suite of a GoogleTest program becomes one test "name.Suite", as a process for
# each of thousands of tests would start longer than it computes; with test_each, each test becomes "name.Suite.Test".
#   test_program, test_name, test_each
#   test_properties     properties of each test but its environment
#   test_environment    variables of its process, a list of its own
if (NOT EXISTS "${test_program}")
  add_test("${test_name}_NOT_BUILT" "${test_program}")
  return ()
endif ()

execute_process(COMMAND "${test_program}" --gtest_list_tests OUTPUT_VARIABLE listed TIMEOUT 60 COMMAND_ERROR_IS_FATAL ANY)
string(REGEX REPLACE " *#[^\n]*" "" listed "${listed}") # values of parameters may hold any sign
string(REGEX MATCHALL "[^\n]+" lines "${listed}")
foreach (line IN LISTS lines)
  string(STRIP "${line}" word)
  set(only "")
  if (line MATCHES "^[^ ].*[.]$") # a suite; its tests follow, with a space before them
    set(suite "${word}")
    if (NOT test_each)
      set(only "${suite}*")
    endif ()
  elseif (line MATCHES "^ " AND test_each)
    set(only "${suite}${word}")
  endif ()
  if (only)
    string(REGEX REPLACE "[.][*]$" "" test "${test_name}.${only}")
    add_test("${test}" "${test_program}" "--gtest_filter=${only}" --gtest_brief=1)
    set_tests_properties("${test}" PROPERTIES ${test_properties} ENVIRONMENT "${test_environment}")
  endif ()
endforeach ()
