# How everything is compiled. Floating point is kept strict so that the same seed gives the same bytes on every machine.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()
set(CMAKE_CXX_FLAGS_RELEASE "-O2")
if(PLICO_SANITIZE)
  set(CMAKE_CXX_FLAGS_RELEASE "-O1")  # instrumented code takes twice as long to compile at -O2
endif()

# Sources of one folder are compiled eight at a time: most of the time goes into headers, and this takes a third of it.
# Names in the unnamed namespace are therefore one of a kind in their folder. OFF while one file is worked on.
option(PLICO_UNITY "Compile the sources of a folder together" ON)
set(CMAKE_UNITY_BUILD ${PLICO_UNITY})
set(CMAKE_UNITY_BUILD_BATCH_SIZE 8)

find_program(PLICO_CCACHE ccache)
if(PLICO_CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${PLICO_CCACHE})
endif()

add_compile_options(-Wall -Wextra -Wpedantic -Wshadow -Werror -ffp-contract=off)
# No path of this folder in what is built: the same bytes wherever it is built.
if(NOT PLICO_COVERAGE)  # whose counters are found by true paths
  add_compile_options(-ffile-prefix-map=${PROJECT_SOURCE_DIR}=.)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # g++ 12 reports false positives in inlined standard library code at -O2.
  add_compile_options(-Wno-restrict -Wno-maybe-uninitialized -Wno-stringop-overflow -Wno-array-bounds)
endif()
if(EMSCRIPTEN)
  add_compile_options(-fwasm-exceptions)
  add_link_options(-fwasm-exceptions)
  set(CMAKE_POSITION_INDEPENDENT_CODE OFF)
endif()
if(PLICO_SANITIZE)
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer -g1)
  # What the address sanitizer finds as well, and what makes a quarter of the code.
  add_compile_options(-fno-sanitize=null,alignment,object-size,vptr)
  add_link_options(-fsanitize=address,undefined)
endif()
if(PLICO_FUZZ)
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()
if(PLICO_COVERAGE)
  add_compile_options(--coverage -g1)
  add_link_options(--coverage)
endif()
