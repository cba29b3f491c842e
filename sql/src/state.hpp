// Declares what the C++ half keeps from call to call, and how it reads operands and writes answers.
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <minksum/minksum.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bridge.h"

namespace minksum::sql {

/// An error that has a status and a hint of its own.
struct Refusal {
  mink_status status = MINK_BAD_INPUT;
  std::string message;
  std::string detail = {};
  std::string hint = {};
};

/// An operand as it was last given.
struct Operand {
  std::string bytes;
  Geometry geometry;
  std::optional<std::int32_t> srid;
  bool known = false;                      ///< whether the members above are set
  bool again = false;                      ///< whether the same bytes came twice
  std::optional<PreparedRegion> prepared;  ///< for sums, once the operand came again
  FillRule prepared_by = FillRule::kAutomatic;
  bool unfit = false;  ///< whether it has thin parts and cannot be prepared
};

inline std::string_view view(mink_bytes bytes) {
  return bytes.size == 0 ? std::string_view() : std::string_view(bytes.data, bytes.size);
}

}  // namespace minksum::sql

/// Everything that C++ allocates for one place of a query, or for one group of an aggregate.
struct mink_state {
  std::array<minksum::sql::Operand, 3> operands;
  minksum::Workspace memory;
  std::array<std::string, 2> written;
  std::string exact;
  std::optional<std::int32_t> srid;

  // Rows that were begun.
  minksum::RoundOptions target;
  bool with_free = false;
  std::optional<minksum::ConfigurationSpace> space;
  minksum::Rational step;  ///< between slices, in degrees
  std::optional<minksum::NoFitTable> table;
  minksum::Options options;

  // An aggregate.
  std::vector<minksum::Geometry> collected;
};

namespace minksum::sql {

/// Returns the choice that a word names. Without a word it is the first one.
template <class Choice>
Choice choose(mink_bytes word, const char* argument, std::initializer_list<Choice> choices) {
  if (word.data == nullptr) return *choices.begin();
  std::string names;
  for (const Choice choice : choices) {
    if (view(word) == to_string(choice)) return choice;
    names += (names.empty() ? "" : ", ") + std::string(to_string(choice));
  }
  throw Refusal{MINK_BAD_INPUT, std::string(argument) + " has no value \"" +
                std::string(view(word)) + '"', {}, "Choose one of: " + names + '.'};
}

/// Returns the library's options. `memory` of the state is used.
Options options_of(mink_state& state, const mink_request& request);
RoundingSide side_of(mink_bytes word, const char* argument);
/// Returns a geometry and its reference system. `index` names it in errors, from 0.
std::pair<Geometry, std::optional<std::int32_t>> read(mink_bytes bytes, bool text, int index,
                                                      const Options& options);
/// Returns the operand with this index, which is read again only if it has changed.
Operand& operand(mink_state& state, const mink_request& request, int index,
                 const Options& options);
/// Takes the reference system of an operand over into the answer's. Two that differ are an error.
void join_srid(std::optional<std::int32_t>& srid, const std::optional<std::int32_t>& other);
/// Writes an answer: exact WKT, or EWKB rounded as `target` says. `place` is that in state.written,
/// and `fit` tells that the geometry is a no-fit polygon.
mink_bytes write(mink_state& state, const Geometry& geometry, bool text,
                 const RoundOptions& target, const Options& options, std::size_t place = 0,
                 bool fit = false);

/// Calls a function and returns what became of it. No exception leaves it.
template <class Function>
mink_status guarded(mink_error* error, Function&& function) noexcept;
/// Describes the exception that is being handled.
mink_status describe(mink_error* error) noexcept;

template <class Function>
mink_status guarded(mink_error* error, Function&& function) noexcept {
  try {
    return std::forward<Function>(function)();
  } catch (...) {
    return describe(error);
  }
}

}  // namespace minksum::sql
