#pragma once
#include <boost/rational.hpp>
#include <geos_c.h>

#include "minksum/adaptors/geos.hpp"
