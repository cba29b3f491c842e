// Tells which options on reading had no effect, because nothing that was read takes them.
#pragma once

#include "minksum/io.hpp"

namespace minksum::cli {

/// The options that some kinds of operands take, and others do not.
enum class ReadingOption { kTolerance, kSide, kLayer, kJoinEnds, kColumn };

inline constexpr const char* kColumnIsUnused =
    "--column has no effect: nothing that was read is a table (CSV, TSV)";

/// Says that something takes the option. All threads may call this, and the next two.
void mark_taken(ReadingOption option);
/// Says that something which this run does not read may take any of them.
void mark_all_taken();
/// Says that a text of this format is read, and so that it takes its options.
void mark_taken_by(io::Format format);

/// Tells, as notes, which of the options that `typed` has were not taken.
void note_unused(const io::ReadOptions& typed);

}  // namespace minksum::cli
