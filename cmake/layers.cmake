# The library's layers: a folder of src/ each, which depends on those it names and on no other.
#
#   taut_layer(NAME [COLD] [USES LAYER...])   makes the target taut_NAME; COLD: of what need not be fast
#   taut_finish_layers()                      after the last one
#
# Each is a library of its own, so that what uses a layer it does not name does not link. With CMAKE_UNITY_BUILD the
# compiler sees two files only, one of all layers that have to be fast and one of the others, and tests/layers_test.py
# sees to what they include: each header is read twice instead of some twenty times, and each template compiled so often.
# Two processors take about as long for the first one as for the other and the programs. (Not for the browser: a linker
# takes whole files, and a page is to be small.)
set(taut_few_files OFF)
if(CMAKE_UNITY_BUILD AND NOT EMSCRIPTEN)
  set(taut_few_files ON)
endif()
if(taut_few_files)
  add_library(taut_fast_layers STATIC)
  target_link_libraries(taut_fast_layers PUBLIC taut_options)
  add_library(taut_cold_layers STATIC)
  # Either has layers that the other one's need: who links one gets both, as often as a linker asks for them.
  target_link_libraries(taut_cold_layers PUBLIC taut_fast_layers)
  target_link_libraries(taut_fast_layers PUBLIC taut_cold_layers)
  target_compile_options(taut_fast_layers PRIVATE ${TAUT_FAST_FLAGS})
  taut_cold(taut_cold_layers)
  set_target_properties(taut_fast_layers taut_cold_layers PROPERTIES UNITY_BUILD_BATCH_SIZE 0)
endif()

set(taut_layer_names "")
function(taut_layer name)
  cmake_parse_arguments(LAYER "COLD" "" "USES" ${ARGN})
  list(TRANSFORM LAYER_USES PREPEND taut_)
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${name}/*.cpp)
  if(taut_few_files)
    set(compiled taut_fast_layers)
    if(LAYER_COLD)
      set(compiled taut_cold_layers)
    endif()
    target_sources(${compiled} PRIVATE ${sources})
    add_library(taut_${name} INTERFACE)
    target_link_libraries(taut_${name} INTERFACE ${compiled})
  else()
    add_library(taut_${name} STATIC ${sources})
    target_link_libraries(taut_${name} PUBLIC taut_options ${LAYER_USES})
    if(LAYER_COLD)
      taut_cold(taut_${name})
    else()
      target_compile_options(taut_${name} PRIVATE ${TAUT_FAST_FLAGS})
    endif()
  endif()
  set(taut_layer_names ${taut_layer_names} ${name} PARENT_SCOPE)
endfunction()

# Where each file is compiled by itself, much of its time would go into headers of others. `taut_compiled` are the
# targets with the library's objects.
function(taut_finish_layers)
  if(taut_few_files)
    set(taut_compiled taut_fast_layers taut_cold_layers PARENT_SCOPE)
    return()
  endif()
  list(TRANSFORM taut_layer_names PREPEND taut_ OUTPUT_VARIABLE compiled)
  set(taut_compiled ${compiled} PARENT_SCOPE)
  taut_precompile(taut_numeric PRIVATE ${taut_common_headers})
  list(REMOVE_ITEM compiled taut_text taut_base taut_numeric)
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
