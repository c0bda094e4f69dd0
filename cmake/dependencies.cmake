# What the library needs, all from Debian's packages (docs/licences.md says under which licence; none of it is GPL).
# The build and the installed CMake package read this one list: the first as find_package, the second as find_dependency.
plico_needs(Eigen3 3.4)
plico_needs(fmt)
plico_needs(nlohmann_json)
plico_needs(Threads)
plico_needs(PkgConfig)
pkg_check_modules(cairo REQUIRED IMPORTED_TARGET GLOBAL cairo)
pkg_check_modules(libpng REQUIRED IMPORTED_TARGET GLOBAL libpng)
pkg_check_modules(libjpeg REQUIRED IMPORTED_TARGET GLOBAL libjpeg)
plico_needs(ZLIB)
plico_needs(pugixml)
pkg_check_modules(ompl REQUIRED IMPORTED_TARGET GLOBAL ompl)
# Its flags name an older C++ standard than ours, and libraries that only its own build needs.
set_target_properties(PkgConfig::ompl PROPERTIES INTERFACE_COMPILE_OPTIONS "" INTERFACE_LINK_DIRECTORIES ""
                                                 INTERFACE_LINK_OPTIONS "" INTERFACE_LINK_LIBRARIES ompl)
pkg_check_modules(nlopt REQUIRED IMPORTED_TARGET GLOBAL nlopt)
