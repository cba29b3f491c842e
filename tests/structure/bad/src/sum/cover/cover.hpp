#pragma once
#include "sum/operands/operands.hpp"
