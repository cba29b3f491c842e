#include "minksum/adaptors/geos.hpp"
