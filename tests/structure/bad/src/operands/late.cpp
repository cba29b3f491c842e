#include "cover/cover.hpp"
