// Results: rounded as a whole, so that they stay valid, and written.
#pragma once

#include <string>

#include "commands/commands.hpp"
#include "output/output_file.hpp"

namespace minksum::cli {

/// How the arguments ask for rounding; not for exact coordinates, which are not rounded.
[[nodiscard]] RoundOptions rounding_of(const ResultArguments& arguments);

/// Writes a geometry whose coordinates are rounded already, or exact; with `properties`, as a
/// GeoJSON Feature.
void write_geometry(OutputFiles& files, const std::string& file, const Geometry& geometry,
                    io::Format format, const io::Coordinates& coordinates,
                    const std::string* properties = nullptr);

/// The geometry, which is resolved, as it is to be written; itself if nothing is to be rounded.
[[nodiscard]] Geometry rounded(const Geometry& geometry, const ResultArguments& arguments);
/// Writes it where and in the format that the arguments say.
void write_geometry(OutputFiles& files, const ResultArguments& arguments, const Geometry& geometry);
/// The same for one that is to be rounded first.
void write_rounded(OutputFiles& files, const ResultArguments& arguments, const Geometry& geometry);

}  // namespace minksum::cli
