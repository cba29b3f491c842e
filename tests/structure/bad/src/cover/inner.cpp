#include "operands/operands.hpp"
#include "operands/inner.hpp"
