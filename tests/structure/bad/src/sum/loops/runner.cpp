#include "sum/pipeline.hpp"
