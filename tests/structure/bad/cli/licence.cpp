#include "minksum/adaptors/cgal.hpp"
