// Finds GDAL at run time, and declares what is used of it. Nothing of GDAL is needed to build.
#pragma once

#include <cstddef>
#include <cstdint>

namespace minksum::io::gdal {

/// The functions of GDAL's C interface that are called, by their names there. It has kept them
/// since GDAL 2.2. Handles are pointers, and flags are integers, as in its headers.
struct Library {
  using Handle = void*;
  void (*GDALAllRegister)();
  Handle (*GDALOpenEx)(const char* name, unsigned flags, const char* const* drivers,
                       const char* const* options, const char* const* siblings);
  void (*GDALClose)(Handle dataset);
  char** (*GDALGetFileList)(Handle dataset);
  int (*GDALDatasetGetLayerCount)(Handle dataset);
  Handle (*GDALDatasetGetLayer)(Handle dataset, int index);
  const char* (*OGR_L_GetName)(Handle layer);
  int (*OGR_L_GetGeomType)(Handle layer);
  Handle (*OGR_L_GetSpatialRef)(Handle layer);
  Handle (*OGR_L_GetNextFeature)(Handle layer);
  std::int64_t (*OGR_L_GetFeatureCount)(Handle layer, int force);
  void (*OGR_F_Destroy)(Handle feature);
  std::int64_t (*OGR_F_GetFID)(Handle feature);
  Handle (*OGR_F_GetGeometryRef)(Handle feature);
  int (*OGR_F_GetFieldCount)(Handle feature);
  Handle (*OGR_F_GetFieldDefnRef)(Handle feature, int field);
  int (*OGR_F_IsFieldSet)(Handle feature, int field);
  int (*OGR_F_IsFieldNull)(Handle feature, int field);
  std::int64_t (*OGR_F_GetFieldAsInteger64)(Handle feature, int field);
  double (*OGR_F_GetFieldAsDouble)(Handle feature, int field);
  const char* (*OGR_F_GetFieldAsString)(Handle feature, int field);
  const char* (*OGR_Fld_GetNameRef)(Handle definition);
  int (*OGR_Fld_GetType)(Handle definition);
  int (*OGR_Fld_GetSubType)(Handle definition);
  int (*OGR_G_WkbSize)(Handle geometry);
  int (*OGR_G_ExportToIsoWkb)(Handle geometry, int byte_order, unsigned char* out);
  const char* (*OSRGetAuthorityName)(Handle system, const char* node);
  const char* (*OSRGetAuthorityCode)(Handle system, const char* node);
  void (*CSLDestroy)(char** list);
  Handle (*VSIFOpenL)(const char* name, const char* mode);
  int (*VSIFCloseL)(Handle file);
  int (*VSIFSeekL)(Handle file, std::uint64_t offset, int whence);
  std::size_t (*VSIFReadL)(void* out, std::size_t size, std::size_t count, Handle file);
  const char* (*CPLReadLineL)(Handle file);
  void (*CPLPushErrorHandler)(void (*handler)(int, int, const char*));
  void (*CPLPopErrorHandler)();
  void (*CPLQuietErrorHandler)(int, int, const char*);
  void (*CPLErrorReset)();
  int (*CPLGetLastErrorType)();
  const char* (*CPLGetLastErrorMsg)();
};

/// Returns GDAL, or null if it is not installed. The environment variable MINKSUM_GDAL may hold the
/// path of the library, or `none`. The first call loads it.
[[nodiscard]] const Library* library();

}  // namespace minksum::io::gdal
