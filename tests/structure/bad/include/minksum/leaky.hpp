#pragma once
#include <boost/rational.hpp>
