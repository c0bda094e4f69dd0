# plico_folder(NAME SEES folder... LINKS_PUBLIC target... LINKS_PRIVATE target...)
# Declares the folder src/plico/NAME as one target. SEES lists the only folders it may include from; the test
# `include_order` compares that with the #include lines.
set_property(GLOBAL PROPERTY PLICO_FOLDERS "")

function(plico_folder name)
  cmake_parse_arguments(ARG "" "" "SEES;LINKS_PUBLIC;LINKS_PRIVATE" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  add_library(plico_${name} OBJECT ${sources})
  target_include_directories(plico_${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>)
  target_link_libraries(plico_${name} PUBLIC Eigen3::Eigen fmt::fmt ${ARG_LINKS_PUBLIC} PRIVATE ${ARG_LINKS_PRIVATE})
  foreach(seen ${ARG_SEES})
    target_link_libraries(plico_${name} PUBLIC plico_${seen})
  endforeach()
  set_property(GLOBAL APPEND PROPERTY PLICO_FOLDERS ${name})
  set_property(GLOBAL PROPERTY PLICO_SEES_${name} "${ARG_SEES}")
  set_property(GLOBAL PROPERTY PLICO_LINKS_${name} "${ARG_LINKS_PUBLIC};${ARG_LINKS_PRIVATE}")
endfunction()
