#include "region/point.hpp"
