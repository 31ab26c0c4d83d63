# The libraries that taut is compared with: `./dev compare --peers`.

# Stops with the name of the Debian package if a library is not there.
function(taut_peer_missing library package)
  message(FATAL_ERROR "TAUT_BENCH_PEERS=ON needs ${library}, which was not found: "
                      "apt-get install ${package}, or configure with -DTAUT_BENCH_PEERS=OFF")
endfunction()

find_package(CLI11 REQUIRED)
find_package(box2d 2.4 QUIET)
if(NOT TARGET box2d::box2d)
  taut_peer_missing("Box2D 2.4" libbox2d-dev)
endif()
find_package(fcl 0.7 QUIET)
if(NOT TARGET fcl)
  taut_peer_missing("FCL 0.7" libfcl-dev)
endif()
find_path(TAUT_BULLET_INCLUDE btBulletCollisionCommon.h PATH_SUFFIXES bullet)
find_library(TAUT_BULLET_COLLISION BulletCollision)
find_library(TAUT_BULLET_MATH LinearMath)
if(NOT TAUT_BULLET_INCLUDE OR NOT TAUT_BULLET_COLLISION OR NOT TAUT_BULLET_MATH)
  taut_peer_missing("Bullet 3" libbullet-dev)
endif()
find_path(TAUT_CHIPMUNK_INCLUDE chipmunk/chipmunk.h)
find_library(TAUT_CHIPMUNK_LIBRARY chipmunk)
if(NOT TAUT_CHIPMUNK_INCLUDE OR NOT TAUT_CHIPMUNK_LIBRARY)
  taut_peer_missing("Chipmunk 7" libchipmunk-dev)
endif()

file(GLOB peer_sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/peers/*.cpp)
list(REMOVE_ITEM peer_sources ${CMAKE_CURRENT_SOURCE_DIR}/peers/convex_pieces.cpp
                              ${CMAKE_CURRENT_SOURCE_DIR}/peers/pose_grid.cpp ${CMAKE_CURRENT_SOURCE_DIR}/peers/worlds.cpp
                              ${CMAKE_CURRENT_SOURCE_DIR}/peers/peer_pair.cpp ${CMAKE_CURRENT_SOURCE_DIR}/peers/verdict.cpp)
add_executable(taut_compare_peers ${peer_sources})
target_include_directories(taut_compare_peers SYSTEM PRIVATE ${TAUT_BULLET_INCLUDE} ${TAUT_CHIPMUNK_INCLUDE})
target_link_libraries(taut_compare_peers PRIVATE taut_peer_support CLI11::CLI11 box2d::box2d fcl
                                                 ${TAUT_BULLET_COLLISION} ${TAUT_BULLET_MATH} ${TAUT_CHIPMUNK_LIBRARY})
set_target_properties(taut_compare_peers PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bench)
