// minksum: exact Minkowski sums of planar regions. Includes the whole public interface.
#pragma once

#include "minksum/error.hpp"
#include "minksum/measure.hpp"
#include "minksum/minkowski_sum.hpp"
#include "minksum/prepared_region.hpp"
#include "minksum/rational.hpp"
#include "minksum/region.hpp"
#include "minksum/trace.hpp"
#include "minksum/validity.hpp"
#include "minksum/version.hpp"
