# Programs we did not write read what we write.
add_test(NAME outside/fold COMMAND ${CMAKE_CURRENT_LIST_DIR}/fold/run ${CMAKE_CURRENT_BINARY_DIR}/outside_fold
                                   ${CMAKE_CURRENT_SOURCE_DIR}/cli/inputs/cube-net.fold 6 5)
set_tests_properties(outside/fold PROPERTIES LABELS outside TIMEOUT 120)

# Debian's interpreter, which is the one that has ezdxf.
find_program(PLICO_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH REQUIRED)
add_test(NAME outside/pages COMMAND ${PLICO_PYTHON} ${CMAKE_CURRENT_LIST_DIR}/pages/check_pages.py
                                    $<TARGET_FILE:plico_program> ${CMAKE_CURRENT_SOURCE_DIR}/cli/inputs/cube-net.fold)
set_tests_properties(outside/pages PROPERTIES LABELS outside TIMEOUT 120)

add_executable(write_samples ${CMAKE_CURRENT_LIST_DIR}/motion/write_samples.cpp)
target_include_directories(write_samples PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(write_samples PRIVATE plico::plico)
add_test(NAME outside/fold_of_nets COMMAND ${CMAKE_CURRENT_LIST_DIR}/fold/run ${CMAKE_CURRENT_BINARY_DIR}/outside_fold_of_nets
                                           $<TARGET_FILE:write_samples>)
set_tests_properties(outside/fold_of_nets PROPERTIES LABELS outside TIMEOUT 120)
foreach(judged pages animations models types)
  add_test(NAME outside/${judged}_of_motions
           COMMAND ${CMAKE_CURRENT_LIST_DIR}/motion/run $<TARGET_FILE:write_samples>
                   ${CMAKE_CURRENT_BINARY_DIR}/outside_${judged} ${PROJECT_SOURCE_DIR}/viewer ${judged})
  set_tests_properties(outside/${judged}_of_motions PROPERTIES LABELS outside TIMEOUT 180)
endforeach()
