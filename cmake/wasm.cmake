# What the `wasm` preset builds with instead of cmake/dependencies.cmake: headers of Debian's packages, seen without the
# rest of /usr/include, and three small libraries compiled from Debian's sources (setup/wasm-sources brings them).
# OMPL, cairo, CaDiCaL, libpng and libjpeg are left out: apps/wasm/instead says what stands for them.
set(include ${PROJECT_BINARY_DIR}/include)
file(MAKE_DIRECTORY ${include})
foreach(header fmt nlohmann CGAL boost)
  file(CREATE_LINK /usr/include/${header} ${include}/${header} SYMBOLIC)
endforeach()
foreach(header Eigen unsupported)
  file(CREATE_LINK /usr/include/eigen3/${header} ${include}/${header} SYMBOLIC)
endforeach()

# One target for all headers; the names are those that the folders link.
add_library(plico_wasm_headers INTERFACE)
target_include_directories(plico_wasm_headers SYSTEM INTERFACE ${include})
target_compile_definitions(plico_wasm_headers INTERFACE FMT_HEADER_ONLY)
foreach(name cadical Eigen3::Eigen fmt::fmt nlohmann_json::nlohmann_json Threads::Threads PkgConfig::ompl PkgConfig::cairo
        PkgConfig::libpng PkgConfig::libjpeg)
  add_library(${name} INTERFACE IMPORTED GLOBAL)
  target_link_libraries(${name} INTERFACE plico_wasm_headers)
endforeach()

# CGAL's kernel with Boost's numbers instead of GMP's. WebAssembly always rounds to nearest.
add_library(plico_cgal_kernel INTERFACE)
target_link_libraries(plico_cgal_kernel INTERFACE plico_wasm_headers)
target_compile_definitions(plico_cgal_kernel INTERFACE CGAL_LICENSE_ERROR=1 CGAL_DISABLE_GMP CGAL_DO_NOT_USE_MPZF
                                                       CGAL_ALWAYS_ROUND_TO_NEAREST)

set(PLICO_WASM_SOURCES ${PROJECT_SOURCE_DIR}/build/wasm-sources CACHE PATH "Where setup/wasm-sources put the sources")
add_subdirectory(apps/wasm/libraries)

# What this toolchain's standard library lacks comes first in every source.
include_directories(BEFORE SYSTEM ${PROJECT_SOURCE_DIR}/apps/wasm/compat)
add_compile_options("SHELL:-include ${PROJECT_SOURCE_DIR}/apps/wasm/compat/compat.h" -Wno-unknown-warning-option)

# Half of the code runs once a click and not in a loop; compiled small it saves a fifth of the page.
function(plico_compile_small target name)
  if(name MATCHES "^(shapes|convex|font|fabricate|project|io|workflow)(/|$)")
    target_compile_options(${target} PRIVATE -Oz)
  endif()
endfunction()
