// minksum: exact Minkowski sums of planar regions. Includes the whole public interface.
#pragma once

#include "minksum/boolean.hpp"
#include "minksum/cancel.hpp"
#include "minksum/check.hpp"
#include "minksum/error.hpp"
#include "minksum/geometry.hpp"
#include "minksum/measure.hpp"
#include "minksum/minkowski_sum.hpp"
#include "minksum/prepared_region.hpp"
#include "minksum/rational.hpp"
#include "minksum/region.hpp"
#include "minksum/resolve.hpp"
#include "minksum/round.hpp"
#include "minksum/trace.hpp"
#include "minksum/validity.hpp"
#include "minksum/version.hpp"
