# CGAL's LGPL kernel, and nothing else of CGAL, for single sources that need exact arithmetic; headers only.
find_package(CGAL REQUIRED)
add_library(plico_cgal_kernel INTERFACE)
target_link_libraries(plico_cgal_kernel INTERFACE CGAL::CGAL)
# Makes any header of CGAL's GPL packages a compile error.
target_compile_definitions(plico_cgal_kernel INTERFACE CGAL_LICENSE_ERROR=1)
