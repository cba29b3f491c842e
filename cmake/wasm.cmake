# Builds for WebAssembly with Debian's emscripten, and runs tests in Node.js.
include(/usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake)
set(CMAKE_DISABLE_PRECOMPILE_HEADERS ON)
# A page has to load the code, so only what takes the time of a sum is compiled for speed: js.
# By -Oz and -Os emscripten lets the compiler inline nothing. With inlining, -Oz inlines where that
# makes the code smaller: the module is then both smaller and faster.
set(CMAKE_CXX_FLAGS_RELEASE "-Oz -finline-functions -DNDEBUG" CACHE STRING "" FORCE)
# Exceptions of WebAssembly itself: those that JavaScript stands in for take several times as long.
# The C++ library lacks some of C++20, which one header completes.
set(CMAKE_C_FLAGS_INIT "-fwasm-exceptions")
set(CMAKE_CXX_FLAGS_INIT
  "-fwasm-exceptions -msimd128 -include ${CMAKE_CURRENT_LIST_DIR}/wasm/standard.hpp")
# Boost's errors name source files. The module must not depend on the folder that it is built in.
string(APPEND CMAKE_CXX_FLAGS_INIT " -fmacro-prefix-map=${CMAKE_BINARY_DIR}/=")
# GoogleTest asks for less by itself, which that header cannot complete.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_EXE_LINKER_FLAGS_INIT
  "-fwasm-exceptions -sENVIRONMENT=node -sALLOW_MEMORY_GROWTH -sSTACK_OVERFLOW_CHECK=0")
# The linker needs a package of Node.js that Debian keeps where only Debian's own Node.js looks.
set_property(GLOBAL PROPERTY RULE_LAUNCH_LINK "${CMAKE_COMMAND} -E env NODE_PATH=/usr/share/nodejs")
# The headers of this system are not those of WebAssembly, so Boost must be seen without the others.
set(Boost_INCLUDE_DIR ${CMAKE_BINARY_DIR}/boost)
get_property(trying GLOBAL PROPERTY IN_TRY_COMPILE)
if(NOT trying)
  file(MAKE_DIRECTORY ${Boost_INCLUDE_DIR})
  file(CREATE_LINK /usr/include/boost ${Boost_INCLUDE_DIR}/boost SYMBOLIC)
endif()
# Threads are declared, and starting one fails. The library starts none unless it is asked to.
set(CMAKE_HAVE_LIBC_PTHREAD TRUE)
# What the linker makes would fetch its own file where it can, and Node.js refuses that from 18 on.
set(CMAKE_CROSSCOMPILING_EMULATOR node --no-experimental-fetch)
