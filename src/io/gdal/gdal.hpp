// Declares how files are read by GDAL, where it is installed.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "io/feature_source.hpp"

namespace minksum::io {

/// Returns the features of a file or folder that GDAL opens as a text that `gdal_source` reads.
/// Returns nothing if GDAL is not installed. `name` says what the file looks like. Throws ReadError
/// if GDAL cannot read it.
[[nodiscard]] std::optional<std::string> features_by_gdal(const std::string& path,
                                                          const std::string& name,
                                                          const ReadOptions& options);

/// Tells whether a text is one of those.
[[nodiscard]] bool looks_like_gdal_features(std::string_view text);
[[nodiscard]] std::unique_ptr<FeatureSource> gdal_source(std::string_view text,
                                                         const ReadOptions& options, Rules rules);

}  // namespace minksum::io
