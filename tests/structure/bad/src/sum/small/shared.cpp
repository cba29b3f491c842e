#include "sum/operands/operands.hpp"
