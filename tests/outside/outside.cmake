# Programs we did not write read what we write.
add_test(NAME outside/fold COMMAND ${CMAKE_CURRENT_LIST_DIR}/fold/run ${CMAKE_CURRENT_BINARY_DIR}/outside_fold
                                   ${CMAKE_CURRENT_SOURCE_DIR}/cli/inputs/cube-net.fold 6 5)
set_tests_properties(outside/fold PROPERTIES LABELS outside TIMEOUT 120)
