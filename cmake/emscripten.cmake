# What a WebAssembly build needs besides the toolchain file. Included for the target taut_options.

# The headers of the outside libraries come from the system, and nothing else may: /usr/include itself in the search
# path would hide emscripten's own C library.
file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/system-headers)
foreach(header boost/version.hpp nlohmann/json.hpp fmt/format.h)
  get_filename_component(library ${header} DIRECTORY)
  find_path(TAUT_${library}_PARENT ${header} PATHS /usr/include /usr/local/include NO_CMAKE_FIND_ROOT_PATH REQUIRED)
  file(CREATE_LINK ${TAUT_${library}_PARENT}/${library} ${CMAKE_BINARY_DIR}/system-headers/${library} SYMBOLIC)
endforeach()
target_include_directories(taut_options SYSTEM INTERFACE ${CMAKE_BINARY_DIR}/system-headers)

# Exceptions by the WebAssembly proposal, not emulated in JavaScript.
target_compile_options(taut_options INTERFACE -fwasm-exceptions)
target_link_options(taut_options INTERFACE -fwasm-exceptions -sALLOW_MEMORY_GROWTH=1 -sNODEJS_CATCH_EXIT=0
                                           -sNODEJS_CATCH_REJECTION=0)
