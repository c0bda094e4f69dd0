# Everything comes from Debian's packages; none of it is GPL (of CGAL only the LGPL kernel is used, guarded below).
find_package(Eigen3 3.4 REQUIRED)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(Threads REQUIRED)
find_package(CGAL REQUIRED)

# Eigen and CGAL are not ours to warn about.
add_library(plico_cgal_kernel INTERFACE)
target_link_libraries(plico_cgal_kernel INTERFACE CGAL::CGAL)
# Makes any header of CGAL's GPL packages a compile error.
target_compile_definitions(plico_cgal_kernel INTERFACE CGAL_LICENSE_ERROR=1)
