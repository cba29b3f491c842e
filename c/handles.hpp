// Defines the handles of the C interface, and turns exceptions into errors.
#pragma once

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>
#include <string_view>
#include <utility>

#include "minksum/io.hpp"
#include "minksum/minksum.hpp"
#include "minksum_c.h"

struct minksum_geometry {
  minksum::Geometry value;
};
struct minksum_prepared {
  minksum::PreparedRegion value;
};
struct minksum_trace {
  minksum::Trace value;
};
struct minksum_locator {
  minksum::PointLocator value;
};
struct minksum_no_fit_table {
  minksum::NoFitTable value;
};
struct minksum_space {
  minksum::ConfigurationSpace value;
  double tolerance;
};

namespace minksum::c {

/// Throws the error of a bad argument.
[[noreturn]] inline void refuse(const char* what) { throw Error(ErrorCode::kBadInput, what); }

inline void require(bool good, const char* what) {
  if (!good) refuse(what);
}

/// Fills `error`, which may be null, and returns `status`.
minksum_status tell(minksum_error* error, minksum_status status, std::string_view message,
                    const Error* cause = nullptr) noexcept;
/// Does the same for the exception being handled, and returns its status.
minksum_status tell_exception(minksum_error* error) noexcept;

/// Runs `work`, and turns any exception into an error. Returns the status.
template <class Work>
minksum_status guarded(minksum_error* error, const Work& work) noexcept {
  try {
    work();
    return tell(error, MINKSUM_OK, {});
  } catch (...) {
    return tell_exception(error);
  }
}
/// Does the same for a function that makes a handle.
template <class Handle, class Make>
minksum_status made(Handle** result, minksum_error* error, const Make& make) noexcept {
  if (result == nullptr) return tell(error, MINKSUM_BAD_INPUT, "the result has nowhere to go");
  *result = nullptr;
  return guarded(error, [&] { *result = new Handle{make()}; });
}

/// Returns the place for a result after setting it to 0, which a failure leaves. Throws for NULL.
template <class Result>
Result& result_at(Result* result) {
  if (result == nullptr) refuse("the result has nowhere to go");
  return *result = {};
}

template <class Handle>
const auto& value_of(const Handle* handle) {
  require(handle != nullptr, "an argument is NULL");
  return handle->value;
}

/// Converts an enumerator of C to that of C++ at the same position. The library refuses one that
/// does not exist.
template <class To, class From>
To as(const From& value) {
  // C may pass any integer. Reading one as an enumerator that does not exist is undefined.
  int number = 0;
  static_assert(sizeof(value) == sizeof(number));
  std::memcpy(&number, &value, sizeof(number));
  return static_cast<To>(number);
}

/// The options of C; null = the defaults.
inline Options options_of(const minksum_options* given) {
  Options options;
  if (given == nullptr) return options;
  options.fill = as<FillRule>(given->fill);
  options.regularize = given->regularize != 0;
  if (given->tight >= 0) options.tight = given->tight != 0;
  if (given->max_segments != 0) options.limits.max_segments = given->max_segments;
  if (given->max_crossings != 0) options.limits.max_crossings = given->max_crossings;
  options.threads = given->threads;
  if (given->progress != nullptr) {
    options.progress = [progress = given->progress, context = given->context](const Progress& p) {
      return progress(context, static_cast<minksum_stage>(p.stage), p.done, p.parts) == 0;
    };
  }
  return options;
}

}  // namespace minksum::c
