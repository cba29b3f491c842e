#pragma once
#include <CGAL/Polygon_2.h>
#include <boost/rational.hpp>
#include <vector>

#include "minksum/adaptors/geos.hpp"
#include "minksum/adaptors/shared.hpp"
