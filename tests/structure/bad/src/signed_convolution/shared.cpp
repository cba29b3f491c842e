#include "predicate/formulas.hpp"
