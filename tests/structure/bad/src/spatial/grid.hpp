#pragma once
#include "machine/clock.hpp"
