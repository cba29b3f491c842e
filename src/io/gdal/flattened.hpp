// Finds curves that GDAL hands over as polylines and polygons, without saying so.
#pragma once

#include <cstdint>
#include <string>

#include "io/gdal/library.hpp"

namespace minksum::io::gdal {

/// These follow the name of a curve in an error.
inline constexpr const char* kNotSupported = " is not supported";
inline constexpr const char* kFlattenFirst =
    ": flatten it first, as by ogr2ogr -f GeoJSON result.json FILE";

/// The curves of one layer: those of MapInfo, and those that GML gives by their centre.
class FlattenedCurves {
 public:
  /// Throws ReadError at the first curve of a text (MIF, GML).
  FlattenedCurves(const Library& gdal, Library::Handle dataset, const std::string& layer,
                  bool is_gml);
  ~FlattenedCurves();
  FlattenedCurves(const FlattenedCurves&) = delete;
  FlattenedCurves& operator=(const FlattenedCurves&) = delete;

  /// Returns what the object of a MapInfo table (TAB) is if it is a curve; or null.
  [[nodiscard]] const char* name_of(std::int64_t object) const;

 private:
  void refuse_in_mif(const std::string& file) const;
  void refuse_in_gml(const std::string& file) const;

  const Library& gdal_;
  Library::Handle places_ = nullptr;   ///< the file .ID, which tells where objects are
  Library::Handle objects_ = nullptr;  ///< the file .MAP
};

}  // namespace minksum::io::gdal
