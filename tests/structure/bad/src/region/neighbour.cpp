#include "spatial/grid.hpp"
