#include "region/up.hpp"
