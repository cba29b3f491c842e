#include "sum/cover/cover.hpp"
