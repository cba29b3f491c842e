#pragma once
#include "sum/cover/cover.hpp"
