#include "loops/loops.hpp"
