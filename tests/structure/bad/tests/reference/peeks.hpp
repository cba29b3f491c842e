#pragma once
#include "region/point.hpp"
