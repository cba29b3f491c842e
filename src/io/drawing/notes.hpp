// Declares what a drawing says about itself, and what was not read of it.
#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "io/geometry_builder.hpp"
#include "minksum/io.hpp"

namespace minksum::io {

/// Counts what is ignored by its name.
using Ignored = std::map<std::string, std::size_t, std::less<>>;

/// Hands on what was read, and the remarks. Throws unless the builder's rules allow it.
void finish(Geometry geometry, const std::string& unit, const Ignored& ignored,
            const std::string& remarks, GeometryBuilder& builder);

}  // namespace minksum::io
