// Draws a sum: the operands on the left, the sum on the right, all to one scale.
#pragma once

#include <optional>
#include <string>

#include "commands/sum_run.hpp"
#include "minksum/geometry.hpp"
#include "minksum/minkowski_sum.hpp"
#include "output/output_file.hpp"

namespace minksum::cli {

/// The captions of a picture.
struct Captions {
  const char* title = "P ⊕ Q";
  const char* p = "P";
  const char* q = "Q";  ///< nullptr = there is only one operand
  const char* sum = "P ⊕ Q";
};

/// Holds what a picture shows: the resolved operands, their sum or another result, and tight places
/// if they were asked for.
struct Drawing {
  Geometry p;
  Geometry q;
  const Geometry& sum;
  const Geometry* tight = nullptr;
  Captions captions;
  /// Whether P is drawn again at its place underneath the result.
  bool p_below = false;
  std::optional<Point> mark = {};  ///< a point of Q that is marked
};
[[nodiscard]] Drawing drawing_of(const SumRun& run, const Options& options);

/// Draws P, Q and P ⊕ Q. Throws Error(kLimitExceeded) if doubles cannot hold the picture.
[[nodiscard]] std::string sum_picture(const Drawing& drawing);

/// Writes that picture to a file.
void write_picture(OutputFiles& files, const std::string& file, const Drawing& drawing);

/// Draws the operands alone.
[[nodiscard]] std::string operands_picture(const Drawing& drawing);

/// Returns a text such as "1,815 vertices, 18 holes", "3 parts, ..." or "2 polylines, 1 point".
[[nodiscard]] std::string summary(const Geometry& geometry);

/// Returns 1234567 as "1,234,567".
[[nodiscard]] std::string grouped(std::uint64_t number);

}  // namespace minksum::cli
