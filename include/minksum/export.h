/* Makes a shared library export the names of the public headers, and no others. */
#ifndef MINKSUM_EXPORT_H
#define MINKSUM_EXPORT_H

/* MINKSUM_SHARED is defined for users of the shared library. MINKSUM_BUILDING is defined while it
 * is built. CMake's targets set both. */
#if defined(_WIN32) && defined(MINKSUM_BUILDING)
#define MINKSUM_API __declspec(dllexport)
#elif defined(_WIN32) && defined(MINKSUM_SHARED)
#define MINKSUM_API __declspec(dllimport)
#elif defined(__GNUC__)
#define MINKSUM_API __attribute__((visibility("default")))
#else
#define MINKSUM_API
#endif

#endif
