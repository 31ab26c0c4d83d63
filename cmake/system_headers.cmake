# For compilers of other systems: headers of outside libraries come from this system, and nothing else may: /usr/include
# itself in the search path would hide the compiler's own C library. Links to these folders alone are in the path.
#
#   taut_system_headers(TARGET HEADER...)   HEADER as it is included, in a folder of its library
function(taut_system_headers target)
  file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/system-headers)
  foreach(header ${ARGN})
    get_filename_component(library ${header} DIRECTORY)
    find_path(TAUT_${library}_PARENT ${header} PATHS /usr/include /usr/local/include NO_CMAKE_FIND_ROOT_PATH REQUIRED)
    file(CREATE_LINK ${TAUT_${library}_PARENT}/${library} ${CMAKE_BINARY_DIR}/system-headers/${library} SYMBOLIC)
  endforeach()
  target_include_directories(${target} SYSTEM INTERFACE ${CMAKE_BINARY_DIR}/system-headers)
endfunction()
