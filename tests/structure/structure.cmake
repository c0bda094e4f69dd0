# The source tree keeps its own rules: who includes whom, and how long a file may be.
get_property(folders GLOBAL PROPERTY PLICO_FOLDERS)
set(declared "")
foreach(folder ${folders})
  get_property(seen GLOBAL PROPERTY PLICO_SEES_${folder})
  list(JOIN seen " " seen)
  string(APPEND declared "${folder} ${seen}\n")
endforeach()
file(WRITE ${PROJECT_BINARY_DIR}/folders.txt "${declared}")

add_test(NAME structure/include_order
  COMMAND ${CMAKE_CURRENT_LIST_DIR}/include_order ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR}/folders.txt)
add_test(NAME structure/include_order_finds_wrong_includes
  COMMAND ${CMAKE_CURRENT_LIST_DIR}/include_order_test)
add_test(NAME structure/file_length COMMAND ${CMAKE_CURRENT_LIST_DIR}/file_length ${PROJECT_SOURCE_DIR})
add_test(NAME structure/one_libm COMMAND ${CMAKE_CURRENT_LIST_DIR}/one_libm ${PROJECT_SOURCE_DIR})
add_test(NAME structure/one_libm_finds_others COMMAND ${CMAKE_CURRENT_LIST_DIR}/one_libm_test)
add_test(NAME structure/doxygen_reads_our_comments COMMAND ${CMAKE_CURRENT_LIST_DIR}/doxygen_filter_test ${PROJECT_SOURCE_DIR})
# What an assertion or debug information calls a file must not depend on where it was built. Coverage needs true paths.
if(NOT PLICO_COVERAGE)
  add_test(NAME structure/no_path_in_program
    COMMAND ${CMAKE_CURRENT_LIST_DIR}/no_path $<TARGET_FILE:plico_program> ${PROJECT_SOURCE_DIR})
  set_tests_properties(structure/no_path_in_program PROPERTIES LABELS structure TIMEOUT 60)
endif()
set_tests_properties(structure/doxygen_reads_our_comments structure/one_libm structure/one_libm_finds_others structure/include_order structure/include_order_finds_wrong_includes structure/file_length
  PROPERTIES LABELS structure TIMEOUT 60)

# What a page tells a reader to type works as it stands there.
foreach(page animal-to-hold pattern-that-moves net-to-robot)
  add_test(NAME structure/guide_commands_of_${page}
    COMMAND ${CMAKE_CURRENT_LIST_DIR}/guide_commands $<TARGET_FILE:plico_program> ${PROJECT_SOURCE_DIR}/docs/guide/${page}.md)
  set_tests_properties(structure/guide_commands_of_${page} PROPERTIES LABELS structure TIMEOUT 120)
endforeach()
