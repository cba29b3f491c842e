#include "sum/loops/loops.hpp"
