#include "operations/sum/fixed_sum.hpp"
