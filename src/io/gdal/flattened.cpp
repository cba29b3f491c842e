#include "io/gdal/flattened.hpp"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string_view>

#include "minksum/io.hpp"

namespace minksum::io::gdal {

namespace {

using File = std::unique_ptr<void, int (*)(Library::Handle)>;

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return result;
}

// Calls `curve_in` with each line of a file. Fails if that names a curve.
template <class CurveIn>
void refuse_lines(const Library& gdal, const std::string& name, CurveIn curve_in) {
  const File file(gdal.VSIFOpenL(name.c_str(), "rb"), gdal.VSIFCloseL);
  if (!file) return;
  std::string curve;
  std::size_t number = 0;
  while (const char* const line = gdal.CPLReadLineL(file.get())) {
    ++number;
    curve = curve_in(std::string_view(line));
    if (!curve.empty()) break;
  }
  gdal.CPLReadLineL(nullptr);  // frees the line
  if (curve.empty()) return;
  throw ReadError(ErrorCode::kBadInput, curve + kNotSupported + kFlattenFirst, number, 0);
}

}  // namespace

FlattenedCurves::FlattenedCurves(const Library& gdal, Library::Handle dataset,
                                 const std::string& layer, bool is_gml)
    : gdal_(gdal) {
  char** const files = gdal.GDALGetFileList(dataset);
  const std::unique_ptr<char*, void (*)(char**)> owner(files, gdal.CSLDestroy);
  for (char** file = files; file != nullptr && *file != nullptr; ++file) {
    const std::filesystem::path path(*file);
    const std::string ending = lower(path.extension().string());
    if (ending == ".gml" || (is_gml && file == files)) refuse_in_gml(*file);
    if (path.stem() != layer) continue;
    if (ending == ".mif") refuse_in_mif(*file);
    if (ending == ".id" && places_ == nullptr) places_ = gdal.VSIFOpenL(*file, "rb");
    if (ending == ".map" && objects_ == nullptr) objects_ = gdal.VSIFOpenL(*file, "rb");
  }
}

FlattenedCurves::~FlattenedCurves() {
  if (places_ != nullptr) gdal_.VSIFCloseL(places_);
  if (objects_ != nullptr) gdal_.VSIFCloseL(objects_);
}

// Objects stand behind the line `Data`, and each begins a line with its name.
void FlattenedCurves::refuse_in_mif(const std::string& file) const {
  refuse_lines(gdal_, file, [are_objects = false](std::string_view line) mutable -> std::string {
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    const std::string word = lower(line.substr(0, line.find_first_of(" \t")));
    are_objects = are_objects || word == "data";
    if (!are_objects) return "";
    return word == "arc"         ? "ARC"
           : word == "ellipse"   ? "ELLIPSE"
           : word == "roundrect" ? "ROUNDRECT"
                                 : "";
  });
}

// GDAL flattens these if coordinates are degrees, and else makes a CIRCULARSTRING of them.
void FlattenedCurves::refuse_in_gml(const std::string& file) const {
  refuse_lines(gdal_, file, [](std::string_view line) -> std::string {
    for (const char* const name : {"ArcByCenterPoint", "CircleByCenterPoint"}) {
      const std::size_t at = line.find(name);
      if (at == std::string_view::npos || at == 0) continue;
      if (line[at - 1] == '<' || line[at - 1] == ':') return name;  // an element's name
    }
    return "";
  });
}

const char* FlattenedCurves::name_of(std::int64_t object) const {
  if (places_ == nullptr || objects_ == nullptr || object < 1) return nullptr;
  constexpr int kFromBegin = 0;  // SEEK_SET
  unsigned char place[4] = {};   // little-endian; 0 for an object without a geometry
  unsigned char kind = 0;
  const auto at = static_cast<std::uint64_t>(object - 1) * sizeof place;
  if (gdal_.VSIFSeekL(places_, at, kFromBegin) != 0) return nullptr;
  if (gdal_.VSIFReadL(place, sizeof place, 1, places_) != 1) return nullptr;
  std::uint64_t begin = 0;
  for (const int i : {3, 2, 1, 0}) begin = begin * 256 + place[i];
  if (begin == 0 || gdal_.VSIFSeekL(objects_, begin, kFromBegin) != 0) return nullptr;
  if (gdal_.VSIFReadL(&kind, 1, 1, objects_) != 1) return nullptr;
  switch (kind) {  // of the two codes of a kind, the first has short coordinates
    case 0x0A:
    case 0x0B:
      return "ARC";
    case 0x16:
    case 0x17:
      return "ROUNDRECT";
    case 0x19:
    case 0x1A:
      return "ELLIPSE";
    default:
      return nullptr;
  }
}

}  // namespace minksum::io::gdal
