// Tells which options on reading had no effect, because nothing that was read takes them.
#pragma once

#include "minksum/io.hpp"

namespace minksum::cli {

/// The options that some kinds of operands take, and others do not.
enum class ReadingOption { kTolerance, kSide, kLayer, kJoinEnds, kColumn };

/// Says that something takes the option.
void mark_taken(ReadingOption option);
/// Says that a text of this format is read, and so that it takes its options.
void mark_taken_by(io::Format format);

/// Tells, as notes, which of the options that `typed` has were not taken.
void note_unused(const io::ReadOptions& typed);

}  // namespace minksum::cli
