# What `cmake --install` puts where: library, headers, packages for CMake and pkg-config; programs, manual page,
# completions and the viewer's page, as far as they are built.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS taut EXPORT tautTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/taut DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})

# The library needs no other one, so that the list of targets is the whole package.
set(taut_package ${CMAKE_INSTALL_LIBDIR}/cmake/taut)
install(EXPORT tautTargets NAMESPACE taut:: FILE tautConfig.cmake DESTINATION ${taut_package})
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/tautConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/tautConfigVersion.cmake DESTINATION ${taut_package})

# Paths from where the file is, so that the installed tree may be moved.
file(RELATIVE_PATH taut_prefix_of_pc /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
configure_file(${PROJECT_SOURCE_DIR}/cmake/taut.pc.in taut.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/taut.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

if(TARGET taut_cli)
  install(TARGETS taut_cli taut_verify RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  # The page of `taut view`, if `./dev web` has built it.
  # To be copied to where Inkscape and FreeCAD look: docs/integrations.md.
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/integrations DESTINATION ${CMAKE_INSTALL_DATADIR}/taut
          PATTERN __pycache__ EXCLUDE)
  install(FILES ${CMAKE_BINARY_DIR}/../web/viewer.html ${CMAKE_BINARY_DIR}/../web/envelope.html DESTINATION ${CMAKE_INSTALL_DATADIR}/taut OPTIONAL)
endif()
if(TARGET taut_cli AND NOT WIN32)
  # The command writes these itself.
  set(manuals ${CMAKE_CURRENT_BINARY_DIR}/manuals)
  file(MAKE_DIRECTORY ${manuals})
  add_custom_command(
    OUTPUT ${manuals}/taut.1 ${manuals}/taut.bash ${manuals}/_taut ${manuals}/taut.fish
    COMMAND taut_cli man > ${manuals}/taut.1
    COMMAND taut_cli completion bash > ${manuals}/taut.bash
    COMMAND taut_cli completion zsh > ${manuals}/_taut
    COMMAND taut_cli completion fish > ${manuals}/taut.fish
    DEPENDS taut_cli)
  add_custom_target(taut_manuals ALL DEPENDS ${manuals}/taut.1)
  install(FILES ${manuals}/taut.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
  install(FILES ${manuals}/taut.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME taut)
  install(FILES ${manuals}/_taut DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions)
  install(FILES ${manuals}/taut.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
endif()
