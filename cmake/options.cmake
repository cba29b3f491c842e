# Compiler options of this project's own targets. Nothing here reaches a user of the library.
function(minksum_own_options target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  # One floating-point contract on every compiler: no fused multiply-add behind our backs.
  target_compile_options(${target} PRIVATE -ffp-contract=off -fno-fast-math
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wnon-virtual-dtor
    -Wold-style-cast -Wcast-qual -Woverloaded-virtual
    $<$<BOOL:${MINKSUM_STRICT}>:-Werror>)
  # Comparisons joined without branches become vectors.
  if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang" AND CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 14)
    target_compile_options(${target} PRIVATE -Wno-bitwise-instead-of-logical)
  endif()
endfunction()
