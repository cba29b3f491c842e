// Rounds results as a whole, so that they stay valid, and writes them.
#pragma once

#include <string>
#include <vector>

#include "commands/commands.hpp"
#include "output/output_file.hpp"

namespace minksum::cli {

/// Returns the rounding that the arguments ask for. They must not ask for exact coordinates, which
/// are not rounded.
[[nodiscard]] RoundOptions rounding_of(const ResultArguments& arguments);

/// Returns the coordinates with the reference system that the operands name. Throws a Failure if
/// they name different ones.
[[nodiscard]] io::Coordinates in_system_of(const io::Coordinates& coordinates,
                                           const io::SourceInfo (&sources)[2],
                                           const std::string (&operands)[2]);
/// Whether a reference system is named.
[[nodiscard]] bool has_system(const io::Coordinates& coordinates);
/// Takes over the reference system alone.
void set_system(io::Coordinates& coordinates, const io::Coordinates& system);
/// Tells, as a note, that the format has no place for the reference system.
void note_lost_system(const io::Coordinates& coordinates, io::Format format);

/// Writes a geometry without rounding it. With `properties` it becomes a GeoJSON Feature.
void write_geometry(OutputFiles& files, const std::string& file, const Geometry& geometry,
                    io::Format format, const io::Coordinates& coordinates,
                    const std::string* properties = nullptr);

/// Returns the geometry as it is to be written: rounded, or unchanged for exact coordinates. The
/// geometry must be resolved, and may have tight places, which are rounded to the nearest.
[[nodiscard]] Geometry rounded(const Geometry& geometry, const ResultArguments& arguments);
/// Does the same, and adds to `notes` what rounding loses, if anything.
[[nodiscard]] Geometry rounded(const Geometry& geometry, const ResultArguments& arguments,
                               std::vector<std::string>& notes);
/// Tells, as a note, how many parts of a geometry are not left in what is written of it, which is
/// rounded to this side.
void note_lost_parts(const Geometry& exact, const Geometry& written, RoundingSide side);
/// Writes the geometry to the file and in the format that the arguments name.
void write_geometry(OutputFiles& files, const ResultArguments& arguments, const Geometry& geometry);
/// Rounds the geometry, and writes it in the same way.
void write_rounded(OutputFiles& files, const ResultArguments& arguments, const Geometry& geometry);

}  // namespace minksum::cli
