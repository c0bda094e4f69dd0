# What cmake --install gives is what others can use. Instrumented builds are not for installing.
if(NOT PLICO_SANITIZE AND NOT PLICO_COVERAGE)
  add_test(NAME install/outside_program COMMAND ${CMAKE_CURRENT_LIST_DIR}/install_test ${PROJECT_BINARY_DIR})
  set_tests_properties(install/outside_program PROPERTIES LABELS install TIMEOUT 300)
endif()
