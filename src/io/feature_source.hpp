// Declares what all readers have in common: they give the features of a text one after another.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

#include "io/geometry_builder.hpp"

namespace minksum::io {

/// A text that is being read. `builder` gets the geometries.
class FeatureSource {
 public:
  FeatureSource(const ReadOptions& options, Rules rules) : builder_(options, rules) {}
  virtual ~FeatureSource() = default;
  FeatureSource(const FeatureSource&) = delete;
  FeatureSource& operator=(const FeatureSource&) = delete;

  /// Adds the next feature to the builder, and counts it. Returns false at the end.
  [[nodiscard]] bool next();
  /// Returns the properties or the id of that feature, as Feature has them.
  [[nodiscard]] virtual std::string properties() const { return {}; }
  [[nodiscard]] virtual std::string id() const { return {}; }
  /// Returns the position in the text at which that feature begins.
  [[nodiscard]] std::size_t start() const { return start_; }
  /// Tells whether the text has lines.
  [[nodiscard]] virtual bool has_lines() const { return true; }
  [[nodiscard]] GeometryBuilder& builder() { return builder_; }

 protected:
  /// Reads the next feature into the builder, and sets `start_`. Returns false at the end.
  virtual bool read_next() = 0;

  GeometryBuilder builder_;
  std::size_t start_ = 0;
  bool is_null_ = false;  ///< set by read_next for a feature without a geometry
};

/// Finds out the format of a text. Both arguments must live as long as the source.
[[nodiscard]] std::unique_ptr<FeatureSource> open_source(std::string_view text,
                                                         const ReadOptions& options, Rules rules);

// A source for each format of many features.
[[nodiscard]] std::unique_ptr<FeatureSource> geojson_source(std::string_view text,
                                                            const ReadOptions& options,
                                                            Rules rules);
/// WKT and hexadecimal WKB, one geometry a line.
[[nodiscard]] std::unique_ptr<FeatureSource> record_source(std::string_view text,
                                                           const ReadOptions& options, Rules rules);
/// Tables, one geometry a row.
[[nodiscard]] std::unique_ptr<FeatureSource> table_source(std::string_view text,
                                                          const ReadOptions& options, Rules rules);

}  // namespace minksum::io
