// Writes the answers of `--each`: as a line that a run keeps, and as the text of the result.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "batch/each_feature.hpp"
#include "minksum/io.hpp"

namespace minksum::cli {

/// Returns the member of a line that holds the text of one answer: `"feature":...` for JSON, or
/// `"text":"..."`. Coordinates name the reference system.
[[nodiscard]] std::string answer_member(const EachSettings& settings, const io::Feature& feature,
                                        const FeatureAnswer& answer,
                                        const io::Coordinates& coordinates);

/// Turns the lines of a run into the text of the result, and tells what is no part of it.
class FeatureText {
 public:
  explicit FeatureText(const EachSettings& settings);
  /// Returns the text before all results. Coordinates name the reference system if it is known.
  [[nodiscard]] std::string begin(const io::Coordinates& coordinates);
  /// Returns the text for one line. Failures are told on standard error.
  [[nodiscard]] std::string add(std::string_view line);
  /// Returns the text behind all results, with the reference system if that came late.
  [[nodiscard]] std::string end(const io::Coordinates& coordinates) const;
  /// Tells how polygons were read that are not valid, and what rounding loses.
  void tell_notes() const;

 private:
  bool collection_;  ///< a FeatureCollection
  bool any_ = false;
  bool has_crs_ = false;  ///< the beginning names it
  struct Told {
    std::uint64_t count = 0;
    std::string first;
  };
  Told notes_;
  Told losses_;
};

}  // namespace minksum::cli
