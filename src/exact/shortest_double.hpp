// Writes doubles in digits.
#pragma once

#include <charconv>

namespace minksum {

/// The most characters that a double takes.
inline constexpr int kDoubleCharacters = 32;

/// Writes a double, not NaN, in the fewest characters that are read as that double, and returns
/// their end. `out` has room for kDoubleCharacters. This is what std::to_chars does, for standard
/// libraries that cannot write doubles.
char* write_shortest_by_search(char* out, double value);

/// Does the same in the quickest way that there is.
inline char* write_shortest(char* out, double value) {
#if defined(__cpp_lib_to_chars)
  return std::to_chars(out, out + kDoubleCharacters, value).ptr;
#else
  return write_shortest_by_search(out, value);
#endif
}

}  // namespace minksum
