#include "sum/cover/inner.hpp"
