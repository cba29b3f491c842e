// Declares the version of the library.
#pragma once

#define MINKSUM_VERSION_MAJOR 0  ///< the first number of the version
#define MINKSUM_VERSION_MINOR 1  ///< the second number of the version
#define MINKSUM_VERSION_PATCH 0  ///< the third number of the version
#define MINKSUM_VERSION "0.1.0"  ///< the three numbers as a text
