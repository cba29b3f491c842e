#include "io/gdal/library.hpp"

#include <cstdlib>
#include <optional>
#include <string>
#include <type_traits>

#if __has_include(<dlfcn.h>) && !defined(__EMSCRIPTEN__)
#include <dlfcn.h>
#define MINKSUM_LOADS_LIBRARIES 1
#endif

namespace minksum::io::gdal {

namespace {

#ifdef MINKSUM_LOADS_LIBRARIES

void* open_library() {
  const char* const given = std::getenv("MINKSUM_GDAL");
  if (given != nullptr && *given != '\0') return dlopen(given, RTLD_LAZY | RTLD_LOCAL);
  // The link without a version belongs to the package for developers, which few users have. GDAL
  // 3.0 has the version 26, and each minor version adds one.
  constexpr int kNewest = 60;
  constexpr int kOldest = 26;
  for (const char* const name : {"libgdal.so", "libgdal.dylib"}) {
    if (void* const found = dlopen(name, RTLD_LAZY | RTLD_LOCAL)) return found;
  }
  for (int version = kNewest; version >= kOldest; --version) {
    const std::string number = std::to_string(version);
    for (const std::string& name : {"libgdal.so." + number, "libgdal." + number + ".dylib"}) {
      if (void* const found = dlopen(name.c_str(), RTLD_LAZY | RTLD_LOCAL)) return found;
    }
  }
  return nullptr;
}

std::optional<Library> load() {
  void* const file = open_library();
  if (file == nullptr) return {};
  Library loaded = {};
  bool complete = true;
  const auto find = [&](auto& function, const char* name) {
    function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(dlsym(file, name));
    complete = complete && function != nullptr;
  };
#define MINKSUM_FIND(name) find(loaded.name, #name)
  MINKSUM_FIND(GDALAllRegister);
  MINKSUM_FIND(GDALOpenEx);
  MINKSUM_FIND(GDALClose);
  MINKSUM_FIND(GDALGetFileList);
  MINKSUM_FIND(GDALDatasetGetLayerCount);
  MINKSUM_FIND(GDALDatasetGetLayer);
  MINKSUM_FIND(OGR_L_GetName);
  MINKSUM_FIND(OGR_L_GetGeomType);
  MINKSUM_FIND(OGR_L_GetSpatialRef);
  MINKSUM_FIND(OGR_L_GetNextFeature);
  MINKSUM_FIND(OGR_L_GetFeatureCount);
  MINKSUM_FIND(OGR_F_Destroy);
  MINKSUM_FIND(OGR_F_GetFID);
  MINKSUM_FIND(OGR_F_GetGeometryRef);
  MINKSUM_FIND(OGR_F_GetFieldCount);
  MINKSUM_FIND(OGR_F_GetFieldDefnRef);
  MINKSUM_FIND(OGR_F_IsFieldSet);
  MINKSUM_FIND(OGR_F_IsFieldNull);
  MINKSUM_FIND(OGR_F_GetFieldAsInteger64);
  MINKSUM_FIND(OGR_F_GetFieldAsDouble);
  MINKSUM_FIND(OGR_F_GetFieldAsString);
  MINKSUM_FIND(OGR_Fld_GetNameRef);
  MINKSUM_FIND(OGR_Fld_GetType);
  MINKSUM_FIND(OGR_Fld_GetSubType);
  MINKSUM_FIND(OGR_G_WkbSize);
  MINKSUM_FIND(OGR_G_ExportToIsoWkb);
  MINKSUM_FIND(OSRGetAuthorityName);
  MINKSUM_FIND(OSRGetAuthorityCode);
  MINKSUM_FIND(CSLDestroy);
  MINKSUM_FIND(VSIFOpenL);
  MINKSUM_FIND(VSIFCloseL);
  MINKSUM_FIND(VSIFSeekL);
  MINKSUM_FIND(VSIFReadL);
  MINKSUM_FIND(CPLReadLineL);
  MINKSUM_FIND(CPLPushErrorHandler);
  MINKSUM_FIND(CPLPopErrorHandler);
  MINKSUM_FIND(CPLQuietErrorHandler);
  MINKSUM_FIND(CPLErrorReset);
  MINKSUM_FIND(CPLGetLastErrorType);
  MINKSUM_FIND(CPLGetLastErrorMsg);
#undef MINKSUM_FIND
  if (!complete) return {};
  // GDAL stays loaded, because it does not support being unloaded.
  loaded.GDALAllRegister();
  return loaded;
}

#else

std::optional<Library> load() { return {}; }

#endif

}  // namespace

const Library* library() {
  static const std::optional<Library> loaded = load();
  return loaded ? &*loaded : nullptr;
}

}  // namespace minksum::io::gdal
