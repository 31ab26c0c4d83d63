# OMPL, for those who plan with taut (taut/ompl.hpp): its tests, examples and benchmark. The library needs none of it.
#
# Defines the target taut_ompl if it is there, and says so if it is not.
if(NOT TARGET taut_ompl)
  find_path(TAUT_OMPL_INCLUDE ompl/base/SpaceInformation.h PATH_SUFFIXES ompl-1.5 ompl-1.6)
  find_path(TAUT_EIGEN_INCLUDE Eigen/Core PATH_SUFFIXES eigen3)
  find_library(TAUT_OMPL_LIBRARY ompl)
  mark_as_advanced(TAUT_OMPL_INCLUDE TAUT_EIGEN_INCLUDE TAUT_OMPL_LIBRARY)
  find_package(Threads)
  if(TAUT_OMPL_INCLUDE AND TAUT_EIGEN_INCLUDE AND TAUT_OMPL_LIBRARY AND Threads_FOUND)
    add_library(taut_ompl INTERFACE)
    target_link_libraries(taut_ompl INTERFACE ${TAUT_OMPL_LIBRARY} Threads::Threads)
    target_include_directories(taut_ompl SYSTEM INTERFACE ${TAUT_OMPL_INCLUDE} ${TAUT_EIGEN_INCLUDE})
  else()
    message(STATUS "OMPL was not found: what plans with taut/ompl.hpp is left out (apt-get install libompl-dev)")
  endif()
endif()
