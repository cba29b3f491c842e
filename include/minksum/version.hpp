// The version of the library.
#pragma once

#define MINKSUM_VERSION_MAJOR 0
#define MINKSUM_VERSION_MINOR 1
#define MINKSUM_VERSION_PATCH 0
#define MINKSUM_VERSION "0.1.0"
