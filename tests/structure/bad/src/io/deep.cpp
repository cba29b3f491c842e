#include "region/region_access.hpp"
