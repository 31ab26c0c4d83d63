# Debian packages, by CPack: `./dev package`. taut has all that is installed; python3-taut2d has the Python package.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME taut)
set(CPACK_PACKAGE_VENDOR "The authors of taut")
set(CPACK_PACKAGE_CONTACT "The authors of taut <taut@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Exactly when moving shapes first touch, or a proof that they never do")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL taut)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_TAUT_PACKAGE_NAME taut)
set(CPACK_COMPONENT_TAUT_DESCRIPTION
    "The programs taut and taut-verify, the C++ library with its headers,\nthe manual page, completions for shells, and the page of the viewer.")
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/taut RENAME copyright)

if(TARGET _taut2d)
  find_package(Python REQUIRED COMPONENTS Interpreter)
  list(APPEND CPACK_COMPONENTS_ALL python)
  # Where Debian's Python looks; the module is for the version that it was compiled for.
  set(taut_python_folder lib/python3/dist-packages/taut2d)
  file(GLOB modules ${PROJECT_SOURCE_DIR}/python/taut2d/*.py ${PROJECT_SOURCE_DIR}/python/taut2d/*.pyi)
  install(TARGETS _taut2d LIBRARY DESTINATION ${taut_python_folder} COMPONENT python EXCLUDE_FROM_ALL)
  install(FILES ${modules} ${PROJECT_SOURCE_DIR}/python/taut2d/py.typed DESTINATION ${taut_python_folder}
          COMPONENT python EXCLUDE_FROM_ALL)
  install(FILES ${CMAKE_BINARY_DIR}/../web/viewer.html DESTINATION ${taut_python_folder} COMPONENT python OPTIONAL
          EXCLUDE_FROM_ALL)
  install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/python3-taut2d COMPONENT python
          RENAME copyright EXCLUDE_FROM_ALL)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-taut2d)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  math(EXPR next_python "${Python_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= 3.${Python_VERSION_MINOR}), python3 (<< 3.${next_python})")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-numpy, python3-matplotlib, python3-shapely")
  set(CPACK_COMPONENT_PYTHON_DESCRIPTION "The Python package taut2d.")
endif()
include(CPack)
