# Toolchain: programs for 64-bit Windows, by Debian's mingw-w64 (the preset `windows`, `./dev windows`).
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)

# The variant with threads by POSIX: the other one of g++ 12 has no std::thread.
set(taut_mingw x86_64-w64-mingw32)
set(CMAKE_C_COMPILER ${taut_mingw}-gcc-posix)
set(CMAKE_CXX_COMPILER ${taut_mingw}-g++-posix)
set(CMAKE_RC_COMPILER ${taut_mingw}-windres)

# Libraries and headers of Windows alone; programs that are run here.
set(CMAKE_FIND_ROOT_PATH /usr/${taut_mingw})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)

# One file each, which needs no other of the compiler's.
set(CMAKE_EXE_LINKER_FLAGS_INIT -static)

# ctest runs what was built by it, where it is there.
find_program(TAUT_WINE wine)
mark_as_advanced(TAUT_WINE)
if(TAUT_WINE)
  set(CMAKE_CROSSCOMPILING_EMULATOR ${TAUT_WINE})
endif()
