# cmake --install gives the program, the library with its headers and CMake package, the manual page and completions,
# and the studio's page where setup/build-studio made one.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/plico)

install(TARGETS plico_program DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS plico EXPORT plico-targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT plico-targets NAMESPACE plico:: DESTINATION ${package})
install(DIRECTORY src/plico DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h")
configure_package_config_file(cmake/plico-config.cmake.in plico-config.cmake INSTALL_DESTINATION ${package})
write_basic_package_version_file(plico-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/plico-config.cmake ${PROJECT_BINARY_DIR}/plico-config-version.cmake
              cmake/dependencies.cmake DESTINATION ${package})

# Written by the program itself, so they cannot disagree with it.
set(written ${PROJECT_BINARY_DIR}/share)
add_custom_command(
  OUTPUT ${written}/plico.1 ${written}/plico.bash ${written}/_plico ${written}/plico.fish
  COMMAND ${CMAKE_COMMAND} -E make_directory ${written}
  COMMAND plico_program man -qf -o ${written}/plico.1
  COMMAND plico_program completions bash -qf -o ${written}/plico.bash
  COMMAND plico_program completions zsh -qf -o ${written}/_plico
  COMMAND plico_program completions fish -qf -o ${written}/plico.fish
  DEPENDS plico_program COMMENT "Writing the manual page and the completions" VERBATIM)
add_custom_target(plico_documents ALL DEPENDS ${written}/plico.1)
install(FILES ${written}/plico.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${written}/plico.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME plico)
install(FILES ${written}/_plico DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions)
install(FILES ${written}/plico.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
install(FILES ${PROJECT_SOURCE_DIR}/build/wasm/plico-studio.html DESTINATION ${CMAKE_INSTALL_DATADIR}/plico OPTIONAL)
install(FILES LICENSE docs/licences.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
