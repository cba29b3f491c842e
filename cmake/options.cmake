# Sets compiler options of this project's own targets, none of which reaches a user of the library.
function(minksum_own_options target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  # Floating point must be the same on every compiler, so fused multiply-add is off.
  target_compile_options(${target} PRIVATE -ffp-contract=off -fno-fast-math
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wnon-virtual-dtor
    -Wold-style-cast -Wcast-qual -Woverloaded-virtual
    # Offsets have 32 bits there, and all that is stored has as many or more.
    $<$<BOOL:${EMSCRIPTEN}>:-Wno-sign-conversion -Wno-shorten-64-to-32>
    $<$<BOOL:${MINKSUM_STRICT}>:-Werror>)
  # Comparisons are joined without branches to become vector instructions; Clang would warn of that.
  if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang" AND CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 14)
    target_compile_options(${target} PRIVATE -Wno-bitwise-instead-of-logical)
  endif()
endfunction()

# Sets further options of libraries. They are position-independent, so that a static one fits into
# somebody's shared library. They export only what the public headers declare.
function(minksum_library_options target)
  minksum_own_options(${target})
  # GCC 12 inlines less where a file has more than 10,000 of its instructions, as joined files and
  # some single ones have. Without this, a build of single files took 1.55 times as long for sums.
  target_compile_options(${target} PRIVATE
    $<$<CXX_COMPILER_ID:GNU>:--param=large-unit-insns=1000000>)
  if(NOT EMSCRIPTEN)
    set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  endif()
  set_target_properties(${target} PROPERTIES
    CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  if(BUILD_SHARED_LIBS)
    target_compile_definitions(${target} PRIVATE MINKSUM_BUILDING INTERFACE MINKSUM_SHARED)
  endif()
endfunction()

# minksum_join_files(TARGET [MANY]) compiles the files of a target by eights, or so many at once, in
# their order. That halves the time of a whole build, most of which is spent on headers and
# templates that files share. Helpers of one file must not have names of helpers of another one.
# -DCMAKE_UNITY_BUILD=OFF compiles each file by itself.
function(minksum_join_files target)
  if(NOT DEFINED CMAKE_UNITY_BUILD)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON)
    if(ARGC GREATER 1)
      set_target_properties(${target} PROPERTIES UNITY_BUILD_BATCH_SIZE ${ARGV1})
    endif()
  endif()
endfunction()

# Precompiles what most files of a target include, so that it is parsed only once.
#   minksum_precompile(TARGET HEADERS...)      makes one of the standard headers and HEADERS
#   minksum_precompile(TARGET REUSE OTHER)     takes that of OTHER, compiled with the same options
# Every file still includes what it uses: a build with CMAKE_DISABLE_PRECOMPILE_HEADERS=ON fails
# where one does not.
function(minksum_precompile target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "REUSE" "")
  if(arg_REUSE)
    target_precompile_headers(${target} REUSE_FROM ${arg_REUSE})
  else()
    target_precompile_headers(${target} PRIVATE
      <algorithm> <array> <bit> <cmath> <compare> <cstddef> <cstdint> <functional> <limits> <map>
      <memory> <numeric> <optional> <span> <string> <string_view> <tuple> <utility> <variant>
      <vector> ${arg_UNPARSED_ARGUMENTS})
  endif()
endfunction()
