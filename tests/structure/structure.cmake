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
set_tests_properties(structure/include_order structure/include_order_finds_wrong_includes structure/file_length
  PROPERTIES LABELS structure TIMEOUT 60)
