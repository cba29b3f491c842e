// The picture of a sum: operands on the left, the sum on the right, all to one scale.
#pragma once

#include <optional>
#include <string>

#include "commands/sum_run.hpp"
#include "minksum/geometry.hpp"
#include "minksum/minkowski_sum.hpp"

namespace minksum::cli {

/// What a picture calls its parts.
struct Captions {
  const char* title = "P ⊕ Q";
  const char* p = "P";
  const char* q = "Q";  ///< nullptr: there is only one operand
  const char* sum = "P ⊕ Q";
};

/// What a picture shows: operands as they were understood, their sum (or what else was made of
/// them), tight places if asked for.
struct Drawing {
  Geometry p;
  Geometry q;
  const Geometry& sum;
  const Geometry* tight = nullptr;
  Captions captions;
  /// Whether P is drawn once more below the result, in its place.
  bool p_below = false;
  std::optional<Point> mark;  ///< a point of Q's that is shown on it
};
[[nodiscard]] Drawing drawing_of(const SumRun& run, const Options& options);

/// Draws P, Q and P ⊕ Q. Throws Error(kLimitExceeded) if doubles cannot hold the picture.
[[nodiscard]] std::string sum_picture(const Drawing& drawing);

/// The operands alone.
[[nodiscard]] std::string operands_picture(const Drawing& drawing);

/// "1,815 vertices, 18 holes", "3 parts, ...", "2 polylines, 1 point".
[[nodiscard]] std::string summary(const Geometry& geometry);

/// 1234567 as "1,234,567".
[[nodiscard]] std::string grouped(std::uint64_t number);

}  // namespace minksum::cli
