// Refuses what callers must not give. Tells enumerators that exist from integers that were cast.
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "minksum/error.hpp"

namespace minksum {

/// Throws Error(kBadInput). Not inlined, to keep the code of callers small.
[[noreturn, gnu::noinline, gnu::cold]] inline void refuse_input(const char* what) {
  throw Error(ErrorCode::kBadInput, what);
}

/// Throws Error(kBadInput) that names the option if `value` is larger. Not inlined, as it is called
/// in many places.
[[gnu::noinline]] inline void require_at_most(unsigned last, unsigned value, const char* option) {
  if (value > last) refuse_input((std::string("there is no such ") + option).c_str());
}
/// Throws Error(kBadInput) that names the option, unless `value` is one of 0, 1, ..., `last`.
template <class Enumeration>
void require_enumerator(Enumeration value, Enumeration last, const char* option) {
  require_at_most(static_cast<unsigned>(last), static_cast<unsigned>(value), option);
}

/// Returns the name of an enumerator, or "unknown".
template <class Enumeration, std::size_t kCount>
const char* name_of(Enumeration value, const std::array<const char*, kCount>& names) {
  const auto index = static_cast<std::size_t>(value);
  return index < kCount ? names[index] : "unknown";
}

}  // namespace minksum
