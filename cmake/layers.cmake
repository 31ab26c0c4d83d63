# The library's layers: a folder of src/ each, which depends on those it names and on no other.
#
#   taut_layer(NAME BASIC|ENGINE|COLD [USES LAYER...])   makes the target taut_NAME; COLD: of what need not be fast
#   taut_finish_layers()                                 after the last one
#
# Each is a library of its own, so that what uses a layer it does not name does not link. With CMAKE_UNITY_BUILD the
# compiler sees one file of the layers of each kind instead, and tests/layers_test.py sees to what they include: each
# header is read three times instead of some twenty times, and each template compiled so often. Two processors take about
# as long for BASIC as for ENGINE, and as for COLD. In WebAssembly a linker takes single functions: a page is no larger.
set(taut_few_files ${CMAKE_UNITY_BUILD})
set(taut_kinds BASIC ENGINE COLD)

# Flags of a kind of layers, for the library that has them.
function(taut_flags_of kind library)
  if(kind STREQUAL COLD)
    taut_cold(${library})
  else()
    target_compile_options(${library} PRIVATE ${TAUT_FAST_FLAGS})
  endif()
endfunction()

if(taut_few_files)
  foreach(kind ${taut_kinds})
    add_library(taut_layers_${kind} STATIC)
    taut_flags_of(${kind} taut_layers_${kind})
    set_target_properties(taut_layers_${kind} PROPERTIES UNITY_BUILD_BATCH_SIZE 0)
    # Each has layers that the others' need: who links one gets all, as often as a linker asks for them.
    set(others ${taut_kinds})
    list(REMOVE_ITEM others ${kind})
    list(TRANSFORM others PREPEND taut_layers_)
    target_link_libraries(taut_layers_${kind} PUBLIC taut_options ${others})
  endforeach()
endif()

# What differs between systems has a file for each (src/io/platform.hpp).
if(WIN32)
  set(taut_other_systems "_posix\\.cpp$")
else()
  set(taut_other_systems "_windows\\.cpp$")
endif()

set(taut_layer_names "")
function(taut_layer name kind)
  cmake_parse_arguments(LAYER "" "" "USES" ${ARGN})
  list(TRANSFORM LAYER_USES PREPEND taut_)
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${name}/*.cpp)
  list(FILTER sources EXCLUDE REGEX ${taut_other_systems})
  if(taut_few_files)
    target_sources(taut_layers_${kind} PRIVATE ${sources})
    add_library(taut_${name} INTERFACE)
    target_link_libraries(taut_${name} INTERFACE taut_layers_${kind})
  else()
    add_library(taut_${name} STATIC ${sources})
    target_link_libraries(taut_${name} PUBLIC taut_options ${LAYER_USES})
    taut_flags_of(${kind} taut_${name})
  endif()
  set(taut_layer_names ${taut_layer_names} ${name} PARENT_SCOPE)
endfunction()

# Where each file is compiled by itself, much of its time would go into headers of others. `taut_compiled` are the
# targets with the library's objects.
function(taut_finish_layers)
  if(taut_few_files)
    list(TRANSFORM taut_kinds PREPEND taut_layers_ OUTPUT_VARIABLE compiled)
    set(taut_compiled ${compiled} PARENT_SCOPE)
    return()
  endif()
  list(TRANSFORM taut_layer_names PREPEND taut_ OUTPUT_VARIABLE compiled)
  set(taut_compiled ${compiled} PARENT_SCOPE)
  taut_precompile(taut_numeric PRIVATE ${taut_common_headers})
  list(REMOVE_ITEM compiled taut_numeric)
  foreach(target ${compiled})
    taut_precompile(${target} REUSE_FROM taut_numeric)
  endforeach()
endfunction()

# Links the library's objects, or those of the layers named, before the program's own. Of an inline function that both
# have, a linker takes the first one: a program that is compiled without optimisation would slow down the library.
function(taut_library_first program)
  set(compiled ${taut_compiled})
  if(ARGN AND NOT taut_few_files)
    list(TRANSFORM ARGN PREPEND taut_ OUTPUT_VARIABLE compiled)
  endif()
  # Without the precompiled headers, which CMake counts among them.
  foreach(target ${compiled})
    target_link_options(${program} PRIVATE $<FILTER:$<TARGET_OBJECTS:${target}>,EXCLUDE,ch$>)
  endforeach()
endfunction()
