// Opens files by GDAL, and hands over the features of one layer.
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <vector>

#include "exact/shortest_double.hpp"
#include "io/gdal/flattened.hpp"
#include "io/gdal/gdal.hpp"
#include "io/gdal/library.hpp"
#include "io/gdal/records.hpp"
#include "io/json_string.hpp"
#include "machine/cancellation.hpp"

namespace minksum::io {

namespace {

using gdal::Library;
using Handle = Library::Handle;

// Values of GDAL's enumerations.
constexpr unsigned kOpenVector = 0x04;
constexpr unsigned kOpenVerbose = 0x40;
constexpr int kNoGeometry = 100;
constexpr int kLittleEndian = 1;
constexpr int kFailure = 3;
enum FieldType { kInteger = 0, kReal = 2, kInteger64 = 12 };
constexpr int kBoolean = 1;

// The drivers that may open an archive. Others would read what minksum reads itself: GeoJSON, whose
// numbers would become doubles, and DXF, whose arcs would become polylines.
constexpr std::array<const char*, 15> kArchiveDrivers = {
    "ESRI Shapefile", "GPKG",    "SQLite",  "FlatGeobuf", "KML",
    "LIBKML",         "GML",     "GPX",     "OSM",        "MapInfo File",
    "OpenFileGDB",    "FileGDB", "Parquet", "Arrow",      nullptr};

/// Keeps GDAL from writing to standard error while it lives.
class Silence {
 public:
  explicit Silence(const Library& gdal) : gdal_(gdal) {
    gdal_.CPLPushErrorHandler(gdal_.CPLQuietErrorHandler);
    gdal_.CPLErrorReset();
  }
  ~Silence() { gdal_.CPLPopErrorHandler(); }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  const Library& gdal_;
};

[[noreturn]] void fail(const std::string& message, ErrorCode code = ErrorCode::kBadInput,
                       const std::optional<ExceededLimit>& limit = {}) {
  throw ReadError(code, message, 0, 0, limit);
}

std::string last_message(const Library& gdal) {
  std::string message = gdal.CPLGetLastErrorMsg();
  while (!message.empty() && (message.back() == '\n' || message.back() == '.')) message.pop_back();
  return message.empty() ? "" : ": " + message;
}

using Owned = std::unique_ptr<void, void (*)(Handle)>;

class LayerReader {
 public:
  LayerReader(const Library& gdal, Handle dataset, Handle layer, const ReadOptions& options,
              bool is_gml)
      : gdal_(gdal),
        layer_(layer),
        options_(options),
        curves_(gdal, dataset, gdal.OGR_L_GetName(layer), is_gml),
        cancel_{.cancel = options.cancel},
        cancellation_(cancel_) {}

  std::string read() {
    text_ = gdal::kMark;
    append_system();
    for (;;) {
      gdal_.CPLErrorReset();
      const Owned feature(gdal_.OGR_L_GetNextFeature(layer_), gdal_.OGR_F_Destroy);
      if (!feature) break;
      ++count_;
      // A part of a file that is cut off gives features without geometry.
      if (gdal_.CPLGetLastErrorType() >= kFailure)
        fail(in_feature() + "GDAL fails" + last_message(gdal_));
      add(feature.get());
      cancellation_.check(text_.size() - counted_to_);
      counted_to_ = text_.size();
      if (text_.size() > options_.max_bytes) {
        fail("the features take more than the limit of " + std::to_string(options_.max_bytes) +
                 " bytes",
             ErrorCode::kLimitExceeded,
             ExceededLimit{"io::ReadOptions::max_bytes", options_.max_bytes});
      }
    }
    if (gdal_.CPLGetLastErrorType() >= kFailure) {
      fail("GDAL fails behind feature " + std::to_string(count_) + last_message(gdal_));
    }
    return std::move(text_);
  }

  /// Fails if there were fewer features than the file says.
  void require_all(std::int64_t announced) const {
    if (announced <= static_cast<std::int64_t>(count_)) return;
    fail("the file says that it has " + std::to_string(announced) + " features, but GDAL finds " +
         std::to_string(count_) + ": it seems to be cut off");
  }

 private:
  void append_system() {
    using gdal::System;
    const Handle system = gdal_.OGR_L_GetSpatialRef(layer_);
    if (system == nullptr) return append(System{0, 0});
    const char* const authority = gdal_.OSRGetAuthorityName(system, nullptr);
    const char* const code = gdal_.OSRGetAuthorityCode(system, nullptr);
    if (authority == nullptr || code == nullptr) return append(System{System::kUnnamed, 0});
    constexpr std::int32_t kWgs84 = 4326;
    if (std::string_view(code) == "CRS84") return append(System{kWgs84, 0});
    if (std::string_view(authority) == "EPSG") return append(System{std::atoi(code), 0});
    const std::string name = std::string(authority) + "::" + code;
    append(System{0, static_cast<std::uint32_t>(name.size())});
    text_ += name;
  }

  void add(Handle feature) {
    const std::int64_t number = gdal_.OGR_F_GetFID(feature);
    if (const char* const curve = curves_.name_of(number)) {
      fail(in_feature() + curve + gdal::kNotSupported + gdal::kFlattenFirst);
    }
    const std::string id = number < 0 ? "" : std::to_string(number);
    const std::string properties = properties_of(feature);
    const Handle geometry = gdal_.OGR_F_GetGeometryRef(feature);
    const int size = geometry == nullptr ? 0 : gdal_.OGR_G_WkbSize(geometry);
    if (size < 0) fail(in_feature() + "its geometry is too large");
    append(gdal::Lengths{id.size(), properties.size(), static_cast<std::uint64_t>(size)});
    text_ += id;
    text_ += properties;
    if (size == 0) return;
    const std::size_t begin = text_.size();
    text_.resize(begin + static_cast<std::size_t>(size));
    auto* const out = reinterpret_cast<unsigned char*>(text_.data() + begin);
    if (gdal_.OGR_G_ExportToIsoWkb(geometry, kLittleEndian, out) != 0) {
      fail(in_feature() + "GDAL cannot write its geometry as WKB" + last_message(gdal_));
    }
  }

  [[nodiscard]] std::string properties_of(Handle feature) const {
    std::string json = "{";
    const int count = gdal_.OGR_F_GetFieldCount(feature);
    for (int field = 0; field < count; ++field) {
      if (gdal_.OGR_F_IsFieldSet(feature, field) == 0) continue;
      const Handle definition = gdal_.OGR_F_GetFieldDefnRef(feature, field);
      json += json.size() > 1 ? ", " : "";
      const std::string name = text_of(gdal_.OGR_Fld_GetNameRef(definition), "the name of a field");
      json += name + ": " + value_of(feature, field, definition, name);
    }
    return json + '}';
  }

  [[nodiscard]] std::string value_of(Handle feature, int field, Handle definition,
                                     const std::string& name) const {
    if (gdal_.OGR_F_IsFieldNull(feature, field) != 0) return "null";
    switch (gdal_.OGR_Fld_GetType(definition)) {
      case kInteger:
      case kInteger64: {
        const std::int64_t value = gdal_.OGR_F_GetFieldAsInteger64(feature, field);
        if (gdal_.OGR_Fld_GetSubType(definition) == kBoolean) return value != 0 ? "true" : "false";
        return std::to_string(value);
      }
      case kReal: {
        const double value = gdal_.OGR_F_GetFieldAsDouble(feature, field);
        if (!std::isfinite(value)) return "null";  // JSON has no other numbers
        char digits[kDoubleCharacters];
        return {digits, write_shortest(digits, value)};
      }
      default:  // dates and lists are written as GDAL does
        return text_of(gdal_.OGR_F_GetFieldAsString(feature, field), "the field " + name);
    }
  }

  [[nodiscard]] std::string text_of(const char* text, const std::string& what) const {
    if (!is_utf8(text)) {
      fail(in_feature() + what +
           " is not UTF-8; GDAL converts a Shapefile whose encoding the environment variable "
           "SHAPE_ENCODING names, such as ISO-8859-1");
    }
    return json_string(text);
  }

  [[nodiscard]] std::string in_feature() const {
    return "feature " + std::to_string(count_) + ": ";
  }

  template <class Value>
  void append(const Value& value) {
    text_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }

  const Library& gdal_;
  Handle layer_;
  const ReadOptions& options_;
  gdal::FlattenedCurves curves_;
  Options cancel_;  ///< of reading
  Cancellation cancellation_;
  std::string text_;
  std::size_t counted_to_ = 0;
  std::size_t count_ = 0;
};

/// Returns the layer to read. Tables without geometries do not count.
Handle choose_layer(const Library& gdal, Handle dataset, const std::string& wanted) {
  constexpr std::size_t kMostNamed = 20;
  std::vector<Handle> layers;
  std::string names;
  const int count = gdal.GDALDatasetGetLayerCount(dataset);
  for (int i = 0; i < count; ++i) {
    const Handle layer = gdal.GDALDatasetGetLayer(dataset, i);
    if (layer == nullptr || gdal.OGR_L_GetGeomType(layer) == kNoGeometry) continue;
    const std::string name = gdal.OGR_L_GetName(layer);
    if (name == wanted) return layer;
    layers.push_back(layer);
    if (layers.size() <= kMostNamed) names += (names.empty() ? "'" : ", '") + name + "'";
  }
  if (layers.empty()) fail("there is no layer of geometries");
  if (layers.size() > kMostNamed) names += " and more";
  if (!wanted.empty()) {
    fail("there is no layer '" + wanted + "' (io::DrawingOptions::layer); there are " + names);
  }
  if (layers.size() > 1) {
    fail("there are " + std::to_string(layers.size()) +
         " layers, and io::DrawingOptions::layer names the one to read: " + names);
  }
  return layers.front();
}

}  // namespace

std::optional<std::string> features_by_gdal(const std::string& path, const std::string& name,
                                            const ReadOptions& options) {
  const Library* const gdal = gdal::library();
  if (gdal == nullptr) return {};
  const Silence silence(*gdal);
  const bool is_archive = name.find(" zip ") != std::string::npos;
  const auto open = [&](const std::string& what) {
    return Owned(gdal->GDALOpenEx(what.c_str(), kOpenVector | kOpenVerbose,
                                  is_archive ? kArchiveDrivers.data() : nullptr, nullptr, nullptr),
                 gdal->GDALClose);
  };
  Owned dataset = open(path);
  if (!dataset && is_archive) dataset = open("/vsizip/{" + path + "}");
  if (!dataset) {
    fail("this looks like " + name + ", but GDAL cannot open it" + last_message(*gdal) +
         (is_archive ? "; unpack it, if it holds a folder, or what is read without GDAL" : ""));
  }
  const Handle layer = choose_layer(*gdal, dataset.get(), options.drawing.layer);
  LayerReader reader(*gdal, dataset.get(), layer, options, name == "GML");
  std::string features = reader.read();
  // GDAL finds the end of a FlatGeobuf that is cut off without an error. Other formats may count
  // deleted features.
  if (name.find("FlatGeobuf") != std::string::npos) {
    reader.require_all(gdal->OGR_L_GetFeatureCount(layer, 0));
  }
  return features;
}

}  // namespace minksum::io
